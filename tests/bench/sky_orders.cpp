// A reference for the sky in all orders of scattering: the single one integrated, the rest traced backwards from the eye
// (Monte Carlo, exact phase functions, round planet, point sun). Prints rows for tests/gl/sky_orders.csv.
//
//     sky_orders PATHS > sky_orders.csv
//
// Shares no code with the renderer, in double precision. Constants are those of the scene's default sky.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>
#include <vector>

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGround = 6360, kTop = 6460; // km
constexpr double kAlbedo = 0.3, kMieG = 0.8;
constexpr double kRayleigh[3] = {5.802e-3, 13.558e-3, 33.1e-3}; // per km
constexpr double kOzone[3] = {0.650e-3, 1.881e-3, 0.085e-3};
constexpr double kMieScattering = 3.996e-3, kMieExtinction = 4.44e-3;

struct Vec {
    double x, y, z;
    Vec operator+(const Vec& o) const { return {x + o.x, y + o.y, z + o.z}; }
    Vec operator*(double f) const { return {x * f, y * f, z * f}; }
};
double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(const Vec& a) { return std::sqrt(dot(a, a)); }
Vec normalized(const Vec& a) { return a * (1 / length(a)); }

double rayleighAt(double h, int c) { return kRayleigh[c] * std::exp(-h / 8); }
double mieAt(double h) { return std::exp(-h / 1.2); }
double extinctionAt(double h, int c)
{
    return rayleighAt(h, c) + kMieExtinction * mieAt(h) + kOzone[c] * std::max(0.0, 1 - std::abs(h - 25) / 15);
}
double rayleighPhase(double c) { return 3 / (16 * kPi) * (1 + c * c); }
double miePhase(double c)
{
    const double g2 = kMieG * kMieG, base = 1 + g2 - 2 * kMieG * c;
    return 3 / (8 * kPi) * (1 - g2) * (1 + c * c) / ((2 + g2) * std::pow(base, 1.5));
}

double toSphere(const Vec& p, const Vec& d, double radius, bool far) // negative: missed
{
    const double b = dot(p, d), disc = b * b - dot(p, p) + radius * radius;
    if (disc < 0) return -1;
    return far ? -b + std::sqrt(disc) : -b - std::sqrt(disc);
}

// Optical depth to space over altitude and the cosine above the horizon's, for the light of the sun.
class SunLight {
public:
    explicit SunLight(int channel)
    {
        for (int i = 0; i < kHeights; ++i)
            for (int j = 0; j < kAngles; ++j)
                m_depth[std::size_t(i) * kAngles + j] = depth(heightOf(i), cosineOf(heightOf(i), j), channel);
    }
    double transmittance(double h, double mu) const
    {
        h = std::clamp(h, 0.0, 99.999);
        const double horizon = horizonOf(h);
        if (mu < horizon) return 0;
        const double x = std::sqrt(h / 100) * (kHeights - 1), y = std::sqrt((mu - horizon) / (1 - horizon)) * (kAngles - 1);
        const int i = std::min(int(x), kHeights - 2), j = std::min(int(y), kAngles - 2);
        const double fx = x - i, fy = y - j;
        const auto at = [&](int a, int b) { return m_depth[std::size_t(a) * kAngles + b]; };
        return std::exp(-((at(i, j) * (1 - fy) + at(i, j + 1) * fy) * (1 - fx) + (at(i + 1, j) * (1 - fy) + at(i + 1, j + 1) * fy) * fx));
    }

private:
    static constexpr int kHeights = 400, kAngles = 400;
    static double heightOf(int i) { return 100 * double(i) * i / ((kHeights - 1.0) * (kHeights - 1.0)); }
    static double horizonOf(double h) { return -std::sqrt(std::max(0.0, 1 - std::pow(kGround / (kGround + h), 2))); }
    static double cosineOf(double h, int j)
    {
        const double s = double(j) / (kAngles - 1);
        return horizonOf(h) + s * s * (1 - horizonOf(h));
    }
    static double depth(double h, double mu, int channel)
    {
        const double r = kGround + h, end = -r * mu + std::sqrt(std::max(r * r * mu * mu + kTop * kTop - r * r, 0.0));
        double sum = 0;
        constexpr int kSteps = 400;
        const double closest = mu < 0 ? -r * mu : 0; // where the ray is lowest: steps gather there
        const auto part = [&](double from, double to) {
            for (int i = 0; i < kSteps; ++i) {
                const auto place = [&](double s) { return from + (to - from) * s * s; };
                const double t = place((i + 0.5) / kSteps), dt = std::abs(place((i + 1.0) / kSteps) - place(double(i) / kSteps));
                sum += dt * extinctionAt(std::max(std::sqrt(r * r + 2 * r * mu * t + t * t) - kGround, 0.0), channel);
            }
        };
        if (closest > 0) part(closest, 0);
        part(closest, end);
        return sum;
    }
    std::vector<double> m_depth = std::vector<double>(std::size_t(kHeights) * kAngles);
};

struct Tracer {
    int channel;
    const SunLight& light;
    Vec sun;
    std::mt19937_64 random{20261126};
    std::uniform_real_distribution<double> unit{0, 1};

    double sunAt(const Vec& p) const
    {
        const double r = length(p);
        return light.transmittance(r - kGround, dot(p, sun) / r);
    }
    static Vec about(const Vec& axis, double cosine, double turn)
    {
        const Vec side = normalized(std::abs(axis.y) < 0.9 ? Vec{axis.z, 0, -axis.x} : Vec{0, axis.z, -axis.y});
        const Vec third{axis.y * side.z - axis.z * side.y, axis.z * side.x - axis.x * side.z, axis.x * side.y - axis.y * side.x};
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        return axis * cosine + side * (sine * std::cos(turn)) + third * (sine * std::sin(turn));
    }
    Vec scatter(const Vec& d, bool mie)
    {
        const double turn = 2 * kPi * unit(random);
        for (;;) { // rejection: from Henyey and Greenstein for Mie, from the even sphere for Rayleigh
            if (!mie) {
                const double c = 2 * unit(random) - 1;
                if (unit(random) * 2 <= 1 + c * c) return about(d, c, turn);
                continue;
            }
            const double g = kMieG, s = (1 - g * g) / (1 - g + 2 * g * unit(random));
            const double c = (1 + g * g - s * s) / (2 * g);
            if (unit(random) * 2 <= 1 + c * c) return about(d, c, turn);
        }
    }
    // Light of the second order and above that leaves a first scattering at `p` against `d`.
    double walk(Vec p, Vec d, bool onGround)
    {
        double total = 0, weight = 1;
        for (int bounce = 0; bounce < 60; ++bounce) {
            if (onGround) {
                const Vec up = normalized(p);
                weight *= kAlbedo;
                d = about(up, std::sqrt(unit(random)), 2 * kPi * unit(random));
            } else {
                const double h = length(p) - kGround, ray = rayleighAt(h, channel), mie = kMieScattering * mieAt(h);
                d = scatter(d, unit(random) * (ray + mie) >= ray);
            }
            // Where the next collision is (Woodcock), its lower bound from the height that the ray cannot go below.
            const double ground = toSphere(p, d, kGround, false), end = ground > 1e-6 ? ground : toSphere(p, d, kTop, true);
            const double r = length(p), mu = dot(p, d) / r;
            const double lowest = ground > 1e-6 ? 0 : mu < 0 ? std::max(r * std::sqrt(1 - mu * mu) - kGround, 0.0) : r - kGround;
            const double most = rayleighAt(lowest, channel) + kMieExtinction * mieAt(lowest) + kOzone[channel];
            double t = 0;
            for (;;) {
                t -= std::log(1 - unit(random)) / most;
                if (t >= end) break;
                if (unit(random) * most < extinctionAt(std::max(length(p + d * t) - kGround, 0.0), channel)) break;
            }
            if (t >= end && !(ground > 1e-6)) return total;
            onGround = t >= end;
            p = p + d * std::min(t, end);
            if (onGround) p = normalized(p) * (kGround + 1e-7);
            const double h = std::max(length(p) - kGround, 0.0), s = sunAt(p);
            if (onGround) {
                total += weight * kAlbedo / kPi * s * std::max(dot(normalized(p), sun), 0.0);
            } else {
                const double ray = rayleighAt(h, channel), mie = kMieScattering * mieAt(h), nu = dot(d, sun);
                weight /= extinctionAt(h, channel);
                total += weight * s * (ray * rayleighPhase(nu) + mie * miePhase(nu));
                weight *= ray + mie;
            }
            if (weight < 0.02 && bounce > 4) {
                if (unit(random) > 0.25) return total;
                weight *= 4;
            }
        }
        return total;
    }
};

struct Result {
    double single, all, deviation;
};

Result look(int channel, const SunLight& light, double altitude, double sunZenith, double viewZenith, double azimuth, int paths)
{
    const auto direction = [](double zenith, double turn) {
        return Vec{std::sin(zenith) * std::cos(turn), std::cos(zenith), std::sin(zenith) * std::sin(turn)};
    };
    constexpr double kDegree = kPi / 180;
    Tracer tracer{channel, light, direction(sunZenith * kDegree, 0)};
    const Vec eye{0, kGround + altitude, 0}, d = direction(viewZenith * kDegree, azimuth * kDegree);
    const double nu = dot(d, tracer.sun), ground = toSphere(eye, d, kGround, false);
    const bool hits = ground > 0;
    const double end = hits ? ground : toSphere(eye, d, kTop, true);

    constexpr int kSteps = 20000;
    std::vector<double> scattered(kSteps + 1, 0);
    double through = 0, single = 0;
    for (int i = 0; i < kSteps; ++i) {
        const auto place = [&](double s) { return end * s * s; };
        const double t = place((i + 0.5) / kSteps), dt = place((i + 1.0) / kSteps) - place(double(i) / kSteps);
        const Vec p = eye + d * t;
        const double h = std::max(length(p) - kGround, 0.0), extinction = extinctionAt(h, channel);
        const double T = std::exp(-(through + extinction * dt / 2));
        const double ray = rayleighAt(h, channel), mie = kMieScattering * mieAt(h);
        single += T * dt * tracer.sunAt(p) * (ray * rayleighPhase(nu) + mie * miePhase(nu));
        scattered[i + 1] = scattered[i] + T * dt * (ray + mie);
        through += extinction * dt;
    }
    double direct = single; // and what the ground in view reflects
    const Vec foot = normalized(eye + d * end) * (kGround + 1e-7);
    if (hits) direct += std::exp(-through) * kAlbedo / kPi * tracer.sunAt(foot) * std::max(dot(normalized(foot), tracer.sun), 0.0);

    const double air = scattered.back(), earth = hits ? std::exp(-through) : 0, all = air + earth;
    double sum = 0, squares = 0;
    for (int i = 0; i < paths; ++i) {
        const double choice = (i + tracer.unit(tracer.random)) / paths * all;
        double more = 0;
        if (choice < air) {
            const auto k = std::upper_bound(scattered.begin(), scattered.end(), choice) - scattered.begin() - 1;
            const double f = (choice - scattered[k]) / (scattered[k + 1] - scattered[k]), s = (double(k) + f) / kSteps;
            more = all * tracer.walk(eye + d * (end * s * s), d, false);
        } else {
            more = all * tracer.walk(foot, d, true);
        }
        sum += more;
        squares += more * more;
    }
    const double mean = sum / paths;
    return {single, direct + mean, std::sqrt(std::max(squares / paths - mean * mean, 0.0) / paths)};
}

} // namespace

int main(int argc, char** argv)
{
    const int paths = argc > 1 ? std::atoi(argv[1]) : 100000;
    const SunLight lights[3] = {SunLight{0}, SunLight{1}, SunLight{2}};
    struct View {
        double zenith, azimuth;
    };
    std::printf("# Radiance per unit of sun irradiance, all orders of scattering, ground albedo 0.3: tests/bench/sky_orders %d.\n", paths);
    std::printf("obs_alt_m,sun_zenith_deg,view_zenith_deg,rel_azimuth_deg,single_r,single_g,single_b,all_r,all_g,all_b,deviation\n");
    for (const double altitude : {2.0, 2000.0, 12000.0, 30000.0})
        for (const double sun : {30.0, 70.0, 82.0, 88.0, 92.0, 94.0, 96.0})
            for (const View view : {View{0, 0}, View{50, 0}, View{50, 180}, View{75, 90}, View{86, 0}, View{86, 180}, View{100, 60}}) {
                if (view.zenith > 90 && altitude < 1000) continue;
                std::array<Result, 3> r;
                double deviation = 0;
                for (int c = 0; c < 3; ++c) {
                    r[c] = look(c, lights[c], altitude / 1000, sun, view.zenith, view.azimuth, paths);
                    deviation = std::max(deviation, r[c].deviation / r[c].all);
                }
                std::printf("%g,%g,%g,%g,%.5e,%.5e,%.5e,%.5e,%.5e,%.5e,%.4f\n", altitude, sun, view.zenith, view.azimuth, r[0].single,
                            r[1].single, r[2].single, r[0].all, r[1].all, r[2].all, deviation);
                std::fflush(stdout);
            }
}
