// Every option of the pack. The comment list of a line is syntax: host and game read it.
#if !defined INCLUDED_SETTINGS
#define INCLUDED_SETTINGS

// Value names, so that `#if GI_METHOD == FLOODFILL` compares numbers. shaders.properties repeats
// the ones it needs.
#define NONE 0
#define AUTO 6  // the host's choice; where it makes none, the pack's

#define PHONG 1
#define LAMBERT_GGX 2
#define PHONG_PUBLISHED 3

#define MAP 1
#define MAP_PCF 2
#define VOLUME_ZPASS 3
#define VOLUME_ZFAIL 4
#define VOLUME_AUTO 5

#define PUBLISHED 1
#define NORMAL_OFFSET 2
#define TEXEL 1
#define HARDWARE 2
#define SOLID_AWARE 2
#define CONSERVING 2

#define BOUNCE_1 1
#define BOUNCE_2 2
#define BOUNCE_4 3
#define FLOODFILL 4
#define FACE_CACHE 5

#define FORWARD 1
#define DEFERRED 2
#define TILED 3
#define CLUSTERED 4

#define LINEAR 1
#define LOGARITHMIC 2

#define SLICE 1
#define COUNT 2
#define HEAT 3

#define HIT 1
#define SAMPLED 2

#define ATLAS_2D 1
#define IMAGE_3D 2

#define GRID 1
#define DISTANCE 2

#define BLOCKS 1
#define RADIANCE 2

#define REINHARD 1
#define ACES 2

// Direct light
#define DIRECT_LIGHT PHONG // [NONE PHONG PHONG_PUBLISHED LAMBERT_GGX]
#define SUN_STRENGTH 8.0 // [0.0 2.0 4.0 6.0 8.0 12.0 16.0]
#define SKY_STRENGTH 1.0 // [0.0 0.25 0.5 1.0 1.5 2.0]
#define EMISSION_STRENGTH 16.0 // [2.0 4.0 8.0 16.0 32.0 64.0]
#define AMBIENT_MINIMUM 0.002 // [0.0 0.002 0.005 0.01 0.02 0.1]
const float sunPathRotation = -30.0; // [-60.0 -45.0 -30.0 -15.0 0.0 15.0 30.0 45.0 60.0]

// Shadows
#define SHADOW_METHOD MAP_PCF // [NONE MAP MAP_PCF VOLUME_ZPASS VOLUME_ZFAIL VOLUME_AUTO AUTO]
#define SHADOW_BIAS NORMAL_OFFSET // [PUBLISHED NORMAL_OFFSET]
#define SHADOW_COMPARE TEXEL // [TEXEL HARDWARE]
#define SHADOW_SNAP // Keep the texels of the map in place in the world
#define SHADOW_DISTORTION 0.0 // [0.0 0.5 0.7 0.85]
#define SHADOW_RESOLUTION 1024 // [256 512 1024 2048 4096]
//#define SHADOW_VIEW // Show where the sun arrives, and nothing else
#define SHADOW_DISTANCE 64.0 // [32.0 48.0 64.0 96.0 128.0]

// Global illumination
#define GI_METHOD FACE_CACHE // [NONE BOUNCE_1 BOUNCE_2 BOUNCE_4 FLOODFILL FACE_CACHE]
#define GI_SAMPLES 1 // [1 2 4 8 16 32]
#define GI_LAMPS SAMPLED // [HIT SAMPLED]
//#define GI_GLOSSY // Polished blocks and metals mirror the voxels about them
#define VOXEL_SIZE AUTO // [32 48 64 96 128 256 AUTO]
#define RAY_WALK DISTANCE // [GRID DISTANCE]
#define VOXEL_VIEW NONE // [NONE BLOCKS RADIANCE]
#define VOXEL_VIEW_FROM 0.0 // [0.0 2.0 4.0 8.0 12.0 16.0 24.0]

//#define GI_COUNTERS // Count voxels written and rays sent

// Many lamps
#define LIGHT_METHOD NONE // [NONE FORWARD DEFERRED TILED CLUSTERED AUTO]
#define LIGHT_RANGE 1.0 // [0.25 0.5 0.75 1.0 1.5]
#define LIGHT_DISTANCE 64 // [32 48 64]
#define LIGHT_SHADOWS 0 // [0 1 2 4 8] Lamps that a point sees or not: the strongest; others shine through walls
#define LIGHT_VOLUMES 0 // [0 1 2 4 8] Lamps near the eye whose shadows are volumes, exact to the pixel
//#define LIGHT_GLOSS // Lamps are reflected as the sun is (DIRECT_LIGHT), with highlights; else as by a diffuse surface
#define LIGHT_CAPACITY 16384 // [256 1024 4096 16384]
#define LIGHT_LIST 512 // [64 128 256 512 1024 2048]
#define LIGHT_COLUMNS 16 // [8 16 20 32]
#define LIGHT_SLICES 24 // [1 8 16 24 32]
#define LIGHT_SLICING LOGARITHMIC // [LINEAR LOGARITHMIC]
#define LIGHT_FIRST_SLICE 4.0 // [1.0 2.0 4.0 5.0]
#define LIGHT_DEBUG NONE // [NONE SLICE COUNT HEAT]

// Floodfill
#define FLOODFILL_STORAGE IMAGE_3D // [ATLAS_2D IMAGE_3D]
#define FLOODFILL_RULE PUBLISHED // [PUBLISHED CONSERVING]
#define FLOODFILL_SKY NONE // [NONE PUBLISHED]
#define FLOODFILL_ALPHA 2.43902 // [0.5 0.9 1.0 2.0 2.2 2.35 2.43902 2.5 2.55 2.65 2.67 2.75]
#define FLOODFILL_GAMMA 2.2 // [1.0 1.8 2.0 2.2 2.4]
#define FLOODFILL_INTERVAL 3 // [1 2 3 4 6]
#define FLOODFILL_LOOKUP PUBLISHED // [PUBLISHED SOLID_AWARE]
#define FLOODFILL_STRENGTH 1.0 // [0.25 0.5 1.0 2.0 4.0 8.0]

// Face cache
#define FACE_SHARE 4 // [1 2 4 8]
#define FACE_WINDOW 128 // [16 32 64 128 256]
#define FACE_GAIN 8.0 // [1.0 4.0 8.0 16.0]
#define FACE_NEAR 0.35 // [0.0 0.25 0.35 0.5 1.0]

// Noise
#define GI_FILTER // Smooth the gathered light within each face
#define TEMPORAL_ACCUMULATION // Reuse the samples of earlier frames
#define TEMPORAL_WEIGHT 0.1 // [0.02 0.05 0.1 0.2 0.5]
#define TEMPORAL_FRAMES 64 // [10 16 32 64 128 256 1024]

// Picture
#define TONE_MAP ACES // [NONE REINHARD ACES]
#define EXPOSURE 1.0 // [0.25 0.5 0.7 1.0 1.4 2.0 4.0]

// Derived: not options.

// Lamps by a list. It is made by compute shaders; without them lamps light as with NONE.
#if LIGHT_METHOD != NONE && defined IS_IRIS && !defined MC_OS_MAC
#define LAMPS 1
#else
#define LAMPS 0
#endif
#define LAMP_SHADOWS (LAMPS && LIGHT_SHADOWS > 0)
// Polished blocks mirror lamps by rays: no highlights beside those.
#ifdef LIGHT_GLOSS
#define LAMP_GLOSS (LAMPS && DIRECT_LIGHT != NONE && !GLOSSY)
#else
#define LAMP_GLOSS 0
#endif
// Their bits are there once the opaque scene is: for what is lit after it.
#if LAMPS && LIGHT_VOLUMES > 0 && LIGHT_METHOD != FORWARD && defined ORRIS_FEATURE_STENCIL_SHADOW_VOLUMES
#define LAMP_VOLUMES 1
#else
#define LAMP_VOLUMES 0
#endif

// Rays of global illumination; blocks for them, or for rays to lamps.
#define GATHERED (GI_METHOD != NONE)
#define VOXELS (GATHERED || LAMP_SHADOWS)

// Shadow volumes where the host has them; elsewhere the map. Rays of global illumination ask for the
// sun at places that no pixel shows, so with them there is a map as well. AUTO is a map here.
#if SHADOW_METHOD >= VOLUME_ZPASS && SHADOW_METHOD != AUTO && defined ORRIS_FEATURE_STENCIL_SHADOW_VOLUMES
#define SHADOW_VOLUMES 1
#else
#define SHADOW_VOLUMES 0
#endif
#define SHADOW_MAP (SHADOW_METHOD != NONE && (!SHADOW_VOLUMES || GATHERED))

// OptiFine has no images, macOS neither images nor compute shaders; shaders.properties says the same.
#if defined IS_IRIS && !defined MC_OS_MAC
#define IMAGES 1
#else
#define IMAGES 0
#endif

// Where the light of the cache is: on faces, or in the air. Without images FACE_CACHE means FLOODFILL.
#if GI_METHOD == FACE_CACHE && IMAGES
#define FACES 1
#else
#define FACES 0
#endif
// Is less drawn of a picture at rest? Where edits of blocks make themselves known.
#ifdef TEMPORAL_ACCUMULATION
#define RESTS FACES
#else
#define RESTS 0
#endif

// Rays that mirrors send look into the cache of faces.
#ifdef GI_GLOSSY
#define GLOSSY FACES
#else
#define GLOSSY 0
#endif
#define AIR_LIGHT (GI_METHOD == FLOODFILL || (GI_METHOD == FACE_CACHE && !FACES))
#define FLOOD_IMAGE (AIR_LIGHT && IMAGES && FLOODFILL_STORAGE == IMAGE_3D)
#if FLOODFILL_RULE == CONSERVING
#define FLOODFILL_FORMAT rgba32f
#define FLOODFILL_IMAGE image3D
#else
#define FLOODFILL_FORMAT rg32ui
#define FLOODFILL_IMAGE uimage3D
#endif

// Is a field of distances to the next block kept for the rays?
#define DISTANCES (VOXELS && IMAGES && RAY_WALK == DISTANCE)

#define LIGHT_GRID (LAMPS && LIGHT_METHOD >= TILED)
#define LAMP_RAYS (FACES && !LAMPS && GI_LAMPS == SAMPLED)
#define LAMPS_FORWARD (LAMPS && LIGHT_METHOD == FORWARD)

// Views of the volume of voxels, and of the grid of clusters.
#define VOXELS_SHOWN (VOXEL_VIEW != NONE && GATHERED)
#define LIGHT_DEBUG_VIEW (LIGHT_DEBUG != NONE && LIGHT_GRID)

#if LIGHT_METHOD == TILED
#define LIGHT_GRID_SLICES 1
#else
#define LIGHT_GRID_SLICES LIGHT_SLICES
#endif

// Tiles about as high as wide on a screen of 16 to 9; shaders.properties repeats columns * rows.
#if LIGHT_COLUMNS == 8
#define LIGHT_ROWS 5
#elif LIGHT_COLUMNS == 16
#define LIGHT_ROWS 9
#elif LIGHT_COLUMNS == 32
#define LIGHT_ROWS 18
#else
#define LIGHT_ROWS 12
#endif

// Does something outlast the frame that is made of the voxels? Then rays see the shapes of stairs, too;
// else these are full blocks.
#define NOTICE_CHANGES (FACES || FLOOD_IMAGE || DISTANCES)

// Are voxels and rays counted? By programs that have images anyway.
#ifdef GI_COUNTERS
#define COUNTED NOTICE_CHANGES
#else
#define COUNTED 0
#endif

// Side of the shadow targets: the voxels need 1024 texels in a row.
#if VOXELS && SHADOW_RESOLUTION < 1024
#define SHADOW_TARGET 1024
#else
#define SHADOW_TARGET SHADOW_RESOLUTION
#endif

// Volumes of 96 and 128 need a shadow target of 2048, 256 (128 high) one of 4096; with a smaller one they
// fall back, in the end to 64, which is also AUTO where the host does not choose. The face cache has at
// most 128. shaders.properties says the same.
#if VOXEL_SIZE == 256 && SHADOW_RESOLUTION >= 4096 && !FACES
#define VOLUME 256
#elif VOXEL_SIZE >= 128 && SHADOW_RESOLUTION >= 2048
#define VOLUME 128
#elif VOXEL_SIZE == 96 && SHADOW_RESOLUTION >= 2048
#define VOLUME 96
#elif VOXEL_SIZE == 32 || VOXEL_SIZE == 48
#define VOLUME VOXEL_SIZE
#else
#define VOLUME 64
#endif
#if VOLUME == 256
#define VOLUME_HEIGHT 128
#else
#define VOLUME_HEIGHT VOLUME
#endif

// Tiles of the atlas (include/voxels/volume.glsl); size.buffer in shaders.properties repeats the
// products ATLAS_COLUMNS * VOLUME and ATLAS_ROWS * VOLUME.
#if VOLUME == 32
#define ATLAS_COLUMNS 32
#define ATLAS_ROWS 1
#elif VOLUME == 48
#define ATLAS_COLUMNS 16
#define ATLAS_ROWS 3
#elif VOLUME == 96
#define ATLAS_COLUMNS 20
#define ATLAS_ROWS 5
#elif VOLUME >= 128
#define ATLAS_COLUMNS 16
#define ATLAS_ROWS 8
#else
#define ATLAS_COLUMNS 16
#define ATLAS_ROWS 4
#endif

const int shadowMapResolution = SHADOW_TARGET;
const float shadowDistance = SHADOW_DISTANCE;
const float shadowDistanceRenderMul = 1.0;

#endif
