// What a frame has, by the options and the host: flags, 0 or 1. shaders.properties repeats the lines that it needs.
// A program says by a flag of its own what it has of an include (HAS_VOXEL_READS, HAS_DISTANCE_WRITES): defined before
// the #include, or not.
#if !defined INCLUDED_DERIVED_FEATURES
#define INCLUDED_DERIVED_FEATURES

// OptiFine has no images, macOS neither images nor compute shaders.
#if defined IS_IRIS && !defined MC_OS_MAC
#define HAS_IMAGES 1
#else
#define HAS_IMAGES 0
#endif

#if defined ORRIS_FEATURE_STENCIL_SHADOW_VOLUMES
#define HAS_STENCIL 1
#else
#define HAS_STENCIL 0
#endif

// Lamps by a list. It is made by compute shaders; without them lamps light as with NONE.
#define HAS_LAMPS (HAS_IMAGES && LIGHT_METHOD != NONE)
#define HAS_FORWARD_LAMPS (HAS_LAMPS && LIGHT_METHOD == LIGHT_METHOD_FORWARD)
#define HAS_LIGHT_GRID (HAS_LAMPS && (LIGHT_METHOD == LIGHT_METHOD_TILED || LIGHT_METHOD == LIGHT_METHOD_CLUSTERED || LIGHT_METHOD == AUTO))
#define HAS_LIGHT_DEBUG (HAS_LIGHT_GRID && LIGHT_DEBUG != NONE)
#define HAS_LAMP_SHADOWS (HAS_LAMPS && LIGHT_SHADOWS > 0)
// Their bits are there once the opaque scene is: for what is lit after it.
#define HAS_LAMP_VOLUMES (HAS_LAMPS && !HAS_FORWARD_LAMPS && HAS_STENCIL && LIGHT_VOLUMES > 0)

// Rays of global illumination; blocks for them, or for rays to lamps.
#define HAS_GI (GI_METHOD != NONE)
#define HAS_VOXELS (HAS_GI || HAS_LAMP_SHADOWS)
#define HAS_VOXEL_VIEW (HAS_GI && VOXEL_VIEW != NONE)

// Where the light of the cache is: on faces, or in the air. Without images FACE_CACHE means FLOODFILL.
#define HAS_FACE_CACHE (HAS_IMAGES && GI_METHOD == GI_METHOD_FACE_CACHE)
#define HAS_AIR_LIGHT (GI_METHOD == GI_METHOD_FLOODFILL || (GI_METHOD == GI_METHOD_FACE_CACHE && !HAS_IMAGES))
#define HAS_FLOOD_IMAGE (HAS_AIR_LIGHT && HAS_IMAGES && FLOODFILL_STORAGE == FLOODFILL_STORAGE_IMAGE_3D)
#define HAS_LAMP_RAYS (HAS_FACE_CACHE && !HAS_LAMPS && GI_LAMPS != GI_LAMPS_HIT)

// Is a field of distances to the next block kept for the rays?
#define HAS_DISTANCES (HAS_VOXELS && HAS_IMAGES && RAY_WALK == RAY_WALK_DISTANCE)

// Does something outlast the frame that is made of the voxels? Then rays see the shapes of stairs, too;
// else these are full blocks.
#define HAS_VOXEL_CHANGES (HAS_FACE_CACHE || HAS_FLOOD_IMAGE || HAS_DISTANCES)

// Is less drawn of a picture at rest? Where edits of blocks make themselves known.
#ifdef TEMPORAL_ACCUMULATION
#define HAS_REST HAS_FACE_CACHE
#else
#define HAS_REST 0
#endif

// Are means of so many frames kept that half floats would stop moving?
#if defined TEMPORAL_ACCUMULATION && TEMPORAL_FRAMES > 128
#define HAS_LONG_MEANS HAS_GI
#else
#define HAS_LONG_MEANS 0
#endif

// Rays that mirrors send look into the cache of faces.
#ifdef GI_GLOSSY
#define HAS_GLOSSY HAS_FACE_CACHE
#else
#define HAS_GLOSSY 0
#endif

// Polished blocks mirror lamps by rays: no highlights beside those.
#ifdef LIGHT_GLOSS
#define HAS_LAMP_GLOSS (HAS_LAMPS && DIRECT_LIGHT != NONE && !HAS_GLOSSY)
#else
#define HAS_LAMP_GLOSS 0
#endif

// Are voxels and rays counted? By programs that have images anyway.
#ifdef GI_COUNTERS
#define HAS_COUNTERS HAS_VOXEL_CHANGES
#else
#define HAS_COUNTERS 0
#endif

// Weather and clouds share the program with water and glass, which have rays of global illumination; with floodfill the light
// of their cells, that of a lamp within the glass, too; with the face cache that of their faces, which is enough for water, if no
// list of lamps adds light that these hold.
#if !defined PROGRAM_WEATHER && !defined PROGRAM_CLOUDS
#define HAS_CACHED_TRANSLUCENTS (HAS_FACE_CACHE && !HAS_LAMPS && GI_TRANSLUCENT == GI_TRANSLUCENT_CACHED)
#define HAS_TRANSLUCENT_RAYS (HAS_GI && !HAS_AIR_LIGHT && !HAS_CACHED_TRANSLUCENTS)
#else
#define HAS_TRANSLUCENT_RAYS 0
#endif
#ifdef TEMPORAL_ACCUMULATION
#define HAS_TRANSLUCENT_MEANS HAS_TRANSLUCENT_RAYS
#else
#define HAS_TRANSLUCENT_MEANS 0
#endif
#ifdef WATER_WAVES
#if !defined PROGRAM_WEATHER && !defined PROGRAM_CLOUDS
#define HAS_WATER_WAVES 1
#else
#define HAS_WATER_WAVES 0
#endif
#else
#define HAS_WATER_WAVES 0
#endif

// Not for views of what is no picture.
#ifdef AUTO_EXPOSURE
#if !defined SHADOW_VIEW
#define HAS_AUTO_EXPOSURE (!HAS_VOXEL_VIEW && !HAS_LIGHT_DEBUG)
#else
#define HAS_AUTO_EXPOSURE 0
#endif
#else
#define HAS_AUTO_EXPOSURE 0
#endif

// Shadow volumes where the host has them; elsewhere the map. Rays of global illumination ask for the
// sun at places that no pixel shows, so with them there is a map as well. AUTO, a lower number, is a map here.
#define HAS_SHADOW_VOLUMES (HAS_STENCIL && SHADOW_METHOD >= SHADOW_METHOD_VOLUME_ZPASS)
#define HAS_SHADOW_MAP (SHADOW_METHOD != NONE && (!HAS_SHADOW_VOLUMES || HAS_GI))

#endif
