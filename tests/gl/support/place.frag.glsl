layout(location = 0) in vec3 place;
layout(location = 0) out vec4 outPlace;

void main()
{
    outPlace = vec4(place, 1.0);
}
