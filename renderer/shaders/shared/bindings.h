// Where buffers and textures are bound. One table, so that nothing meets by chance.
#ifndef SHARED_BINDINGS_H
#define SHARED_BINDINGS_H

// Uniform blocks
#define VIEW_BINDING 0
#define LIGHT_BINDING 1
#define TERRAIN_BINDING 2
#define PASS_BINDING 3
#define SKY_LIGHT_BINDING 4
#define HEAVENS_BINDING 5
#define SHADOWS_BINDING 6
#define LAMPS_BINDING 7
#define CLOUDS_BINDING 8
#define PICTURE_BINDING 9 // light shafts, or the exposure that was chosen
#define WATER_BINDING 10 // and PARTICLES_BINDING: passes of their own
#define PARTICLES_BINDING 10
#define GRASS_BINDING 11

// Storage blocks
#define SKY_LIGHT_STORAGE_BINDING 0 // the same buffer while it is written
#define EXPOSURE_STORAGE_BINDING 1

#define CULL_RECORDS_BINDING 0
#define CULL_MODELS_BINDING 1
#define CULL_BINS_BINDING 2
#define CULL_DECIDED_BINDING 3
#define CULL_SEEN_BINDING 4
#define CULL_COUNTS_BINDING 5
#define CULL_INSTANCES_BINDING 6
#define CULL_DRAWN_BINDING 7
#define CULL_PARTS_BINDING 0    // where commands are made
#define CULL_COMMANDS_BINDING 1

#define GRASS_BLADES_BINDING 0
#define GRASS_COUNTS_BINDING 1
#define GRASS_TILES_BINDING 2
#define GRASS_COMMANDS_BINDING 3
#define GRASS_PLANTS_BINDING 4
#define GRASS_PARTS_BINDING 5
#define GRASS_PLANT_COMMANDS_BINDING 6
#define GRASS_FOUND_BINDING 7

// Texture units. A pass either draws materials, or the ground, or reads the GBuffer: the first five are shared.
#define BASE_COLOUR_UNIT 0
#define SURFACE_UNIT 1 // roughness in G, metallic in B
#define NORMAL_UNIT 2
#define OCCLUSION_UNIT 3
#define EMISSIVE_UNIT 4

#define HEIGHTS_UNIT 0
#define GROUND_NORMALS_UNIT 1
#define LAYER_COLOURS_UNIT 2
#define LAYER_NORMALS_UNIT 3
#define COVER_UNIT 4
#define FLOW_UNIT 15

#define GBUFFER_COLOUR_UNIT 0
#define GBUFFER_NORMAL_UNIT 1
#define GBUFFER_SURFACE_UNIT 2
#define GBUFFER_ID_UNIT 3
#define GBUFFER_DEPTH_UNIT 4

#define SHADOW_UNIT 5
#define SKY_VIEW_UNIT 6
#define TRANSMITTANCE_UNIT 7
#define NOISE_UNIT 8
#define MULTI_SCATTER_UNIT 9
#define IMAGE_UNIT 10
#define GROUND_SHADOW_UNIT 11
#define SKY_MIRROR_UNIT 12
#define AERIAL_UNIT 13
#define CLOUD_MAP_UNIT 16
#define SHADOW_DEPTH_UNIT 17 // the shadow maps as numbers
#define AMBIENT_OCCLUSION_UNIT 18
#define LAMPS_UNIT 19
#define LAMP_LISTS_UNIT 20
#define LAMP_SHADOW_UNIT 30
#define CLOUD_SHAPE_UNIT 21
#define CLOUD_DETAIL_UNIT 22
#define CLOUD_IMAGE_UNIT 23
#define SHAFTS_UNIT 24  // a volume, or a small picture
#define BLOOM_UNIT 25
#define HISTORY_UNIT 26 // the last frame; while edges are smoothed, where they are

// Of water, and of particles.
#define RIPPLES_UNIT 27
#define BEHIND_UNIT 28       // the lit picture that water is drawn over
#define BEHIND_DEPTH_UNIT 29 // and its depth
#define PARTICLE_ATLAS_UNIT 27

// Of grass while it is placed.
#define GRASS_MAP_UNIT 24
#define GRASS_MASK_UNIT 25
#define GROUND_TINT_UNIT 26

// Records that vertices read are buffer textures: software GL fetches a texel far faster than it reads a storage block.
#define MATERIALS_UNIT 14

#endif
