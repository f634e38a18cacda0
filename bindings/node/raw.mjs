// SPDX-License-Identifier: Apache-2.0
// Made by scripts/interface from the headers in include/abut, where each name is described. Do not edit.
import koffi from 'koffi';

const vector = koffi.struct('abut_vec3', { x: 'double', y: 'double', z: 'double' });
const quaternion = koffi.struct('abut_quat', { w: 'double', x: 'double', y: 'double', z: 'double' });
const pose = koffi.struct('abut_pose', { position: vector, orientation: quaternion });
const aabb = koffi.struct('abut_aabb', { minimum: vector, maximum: vector });
const partId = koffi.struct('abut_part_id', { slot: 'uint32_t', generation: 'uint32_t' });
const geometryId = koffi.struct('abut_geometry_id', { slot: 'uint32_t', generation: 'uint32_t' });
const feature = koffi.struct('abut_feature', { kind: 'uint32_t', index: 'uint32_t' });
const hullReport = koffi.struct('abut_hull_report', { structSize: 'uint32_t', dimension: 'uint32_t',
  pointCount: 'uint64_t', vertexCount: 'uint64_t', edgeCount: 'uint64_t', faceCount: 'uint64_t', error: 'double' });
const meshOptions = koffi.struct('abut_mesh_options', { structSize: 'uint32_t', sides: 'uint32_t', corners: 'uint32_t',
  mergesVertices: 'uint32_t', mergeDistance: 'double', tree: 'uint32_t', reserved: 'uint32_t' });
const meshReport = koffi.struct('abut_mesh_report', { structSize: 'uint32_t', reserved: 'uint32_t',
  triangles: 'uint64_t', vertices: 'uint64_t', mergedVertices: 'uint64_t', collapsedTriangles: 'uint64_t',
  duplicateVertices: 'uint64_t', duplicateTriangles: 'uint64_t', slivers: 'uint64_t', openEdges: 'uint64_t',
  nonManifoldEdges: 'uint64_t', reversedTriangles: 'uint64_t', twistedPatches: 'uint64_t', components: 'uint64_t',
  mergeError: 'double', volume: 'double' });
const uvGridOptions = koffi.struct('abut_uv_grid_options', { structSize: 'uint32_t', sides: 'uint32_t',
  axisU: 'uint32_t', axisV: 'uint32_t', cellsU: 'uint32_t', cellsV: 'uint32_t', corners: 'uint32_t',
  mergesVertices: 'uint32_t', mergeDistance: 'double' });
const heightFieldDesc = koffi.struct('abut_height_field_desc', { structSize: 'uint32_t', diagonal: 'uint32_t',
  columns: 'uint32_t', rows: 'uint32_t', spacingX: 'double', spacingY: 'double', heights: 'double *', below: 'uint32_t',
  reserved: 'uint32_t' });
const distanceFieldDesc = koffi.struct('abut_distance_field_desc', { structSize: 'uint32_t', isInsideOut: 'uint32_t',
  columns: 'uint32_t', rows: 'uint32_t', layers: 'uint32_t', interpolation: 'uint32_t', spacing: vector, origin: vector,
  values: 'double *' });
const distanceFieldOptions = koffi.struct('abut_distance_field_options', { structSize: 'uint32_t',
  isInsideOut: 'uint32_t', spacing: 'double', band: 'double', interpolation: 'uint32_t', reserved: 'uint32_t' });
const distanceFieldReport = koffi.struct('abut_distance_field_report', { structSize: 'uint32_t',
  interpolation: 'uint32_t', blockCount: 'uint64_t', heldBlockCount: 'uint64_t', error: 'double', farError: 'double',
  leastStretch: 'double', mostStretch: 'double' });
const compositeChild = koffi.struct('abut_composite_child', { pose: pose, material: 'uint32_t', isHole: 'uint32_t',
  cutBegin: 'uint32_t', cutEnd: 'uint32_t' });
const shapeDesc = koffi.struct('abut_shape_desc', { structSize: 'uint32_t', kind: 'uint32_t', parameters: 'double *',
  parameterCount: 'uint64_t', reals: 'double *', realCount: 'uint64_t', indices: 'uint32_t *', indexCount: 'uint64_t'
  });
const ray = koffi.struct('abut_ray', { origin: vector, direction: vector, maxDistance: 'double' });
const rayHit = koffi.struct('abut_ray_hit', { distance: 'double', point: vector, normal: vector, feature: feature,
  child: 'uint32_t', reserved: 'uint32_t' });
const queryOptions = koffi.struct('abut_query_options', { structSize: 'uint32_t', algorithm: 'uint32_t',
  errorBound: 'double', margin: 'double', maxContacts: 'uint32_t', maxPairContacts: 'uint32_t', threads: 'uint32_t',
  flags: 'uint32_t', timeBudget: 'double' });
const route = koffi.struct('abut_route', { algorithm: 'uint32_t', flags: 'uint32_t', errorBound: 'double',
  seconds: 'double', worstError: 'double' });
const distance = koffi.struct('abut_distance', { distance: 'double', lower: 'double', upper: 'double', pointA: vector,
  pointB: vector, normal: vector, algorithm: 'uint32_t', iterations: 'uint32_t' });
const contact = koffi.struct('abut_contact', { geometryA: geometryId, geometryB: geometryId, id: 'uint64_t',
  featureA: feature, featureB: feature, childA: 'uint32_t', childB: 'uint32_t', pointA: vector, pointB: vector,
  normal: vector, distance: 'double', toi: 'double', flags: 'uint32_t', age: 'uint32_t', userData: 'uint64_t',
  materialA: 'uint32_t', materialB: 'uint32_t', tangent: vector, reserved: 'uint64_t' });
const pairMemory = koffi.struct('abut_pair_memory', { opaque: koffi.array('uint64_t', 8) });
const firstTouch = koffi.struct('abut_first_touch', { touches: 'uint32_t', reserved: 'uint32_t', lower: 'double',
  upper: 'double' });
const elementCounts = koffi.struct('abut_element_counts', { vertices: 'uint64_t', edges: 'uint64_t',
  triangles: 'uint64_t', faces: 'uint64_t' });
const elementsOptions = koffi.struct('abut_elements_options', { structSize: 'uint32_t', method: 'uint32_t',
  kinds: 'uint32_t', flags: 'uint32_t', threads: 'uint32_t', reserved: 'uint32_t', reach: 'double', tolerance: 'double',
  restDistance: 'double', coneAngle: 'double', coneFactor: 'double' });
const stencil = koffi.struct('abut_stencil', { kind: 'uint32_t', ofA: 'uint32_t', elementA: 'uint32_t',
  elementB: 'uint32_t', vertices: koffi.array('uint32_t', 4), weights: koffi.array('double', 4), normal: vector,
  distance: 'double', toi: 'double' });
const elementPair = koffi.struct('abut_element_pair', { kind: 'uint32_t', a: 'uint32_t', b: 'uint32_t' });
const crossing = koffi.struct('abut_crossing', { edge: 'uint32_t', face: 'uint32_t', edgeIsOfB: 'uint32_t',
  reserved: 'uint32_t', share: 'double', point: vector });
const movement = koffi.struct('abut_movement', { velocity: vector, angularVelocity: vector, acceleration: vector,
  angularAcceleration: vector, centre: vector });
const impactOptions = koffi.struct('abut_impact_options', { structSize: 'uint32_t', mostRounds: 'uint32_t',
  tolerance: 'double', margin: 'double', threads: 'uint32_t', reserved: 'uint32_t' });
const impact = koffi.struct('abut_impact', { state: 'uint32_t', rounds: 'uint32_t', lower: 'double', upper: 'double',
  contact: distance, childA: 'uint32_t', childB: 'uint32_t' });
const universeOptions = koffi.struct('abut_universe_options', { structSize: 'uint32_t', broadphase: 'uint32_t',
  toleranceMode: 'uint32_t', maxContacts: 'uint32_t', origin: vector, threads: 'uint32_t', events: 'uint32_t',
  flags: 'uint32_t', maxPairContacts: 'uint32_t' });
const partOptions = koffi.struct('abut_part_options', { structSize: 'uint32_t', motion: 'uint32_t', pose: pose,
  userData: 'uint64_t' });
const sleep = koffi.struct('abut_sleep', { structSize: 'uint32_t', steps: 'uint32_t', linearSpeed: 'double',
  linearAcceleration: 'double', angularSpeed: 'double', angularAcceleration: 'double' });
const geometryOptions = koffi.struct('abut_geometry_options', { structSize: 'uint32_t', flags: 'uint32_t', pose: pose,
  tolerance: 'double', userData: 'uint64_t', layers: 'uint64_t', mask: 'uint64_t', exclusion: 'uint64_t',
  label: 'uint32_t', tag: 'uint32_t', material: 'uint32_t', parking: 'uint32_t' });
const geometryInfo = koffi.struct('abut_geometry_info', { structSize: 'uint32_t', kind: 'uint32_t', part: partId,
  shape: 'void *', pose: pose, local: pose, tolerance: 'double', userData: 'uint64_t', layers: 'uint64_t',
  mask: 'uint64_t', exclusion: 'uint64_t', label: 'uint32_t', tag: 'uint32_t', material: 'uint32_t',
  parking: 'uint32_t', flags: 'uint32_t', reserved: 'uint32_t' });
const revision = koffi.struct('abut_revision', { geometries: 'uint64_t', poses: 'uint64_t' });
const collidable = koffi.struct('abut_collidable', { kind: 'uint32_t', slot: 'uint32_t', generation: 'uint32_t' });
const policy = koffi.struct('abut_policy', { structSize: 'uint32_t', algorithm: 'uint32_t', detail: 'uint32_t',
  period: 'uint32_t', tolerance: 'double', errorBound: 'double', method: 'uint32_t', kinds: 'uint32_t',
  flags: 'uint32_t', reserved: 'uint32_t', contactDistance: 'double', restDistance: 'double', coneAngle: 'double',
  coneFactor: 'double', timeBudget: 'double' });
const focus = koffi.struct('abut_focus', { structSize: 'uint32_t', nearTag: 'uint32_t', farTag: 'uint32_t',
  reserved: 'uint32_t', nearDistance: 'double', farDistance: 'double' });
const contactMaterial = koffi.struct('abut_contact_material', { structSize: 'uint32_t', reserved: 'uint32_t',
  frictionPrimary: 'double', frictionSecondary: 'double', frictionSpin: 'double', frictionRoll: 'double',
  staticScale: 'double', slip: 'double', compliance: 'double', damping: 'double', restitution: 'double',
  restitutionThreshold: 'double', adhesiveForce: 'double' });
const backendPair = koffi.struct('abut_backend_pair', { geometryA: geometryId, geometryB: geometryId, shapeA: 'void *',
  shapeB: 'void *', poseA: pose, poseB: pose, margin: 'double' });
const backendContact = koffi.struct('abut_backend_contact', { pointA: vector, pointB: vector, normal: vector,
  featureA: feature, featureB: feature, childA: 'uint32_t', childB: 'uint32_t', id: 'uint64_t' });
const event = koffi.struct('abut_event', { kind: 'uint32_t', flags: 'uint32_t', geometryA: geometryId,
  geometryB: geometryId, contactId: 'uint64_t', firstContact: 'uint32_t', contactCount: 'uint32_t' });
const sleepChange = koffi.struct('abut_sleep_change', { part: partId, isAsleep: 'uint32_t', reserved: 'uint32_t' });
const localPoints = koffi.struct('abut_local_points', { a: vector, b: vector });
const stepStats = koffi.struct('abut_step_stats', { structSize: 'uint32_t', reserved: 'uint32_t', parts: 'uint64_t',
  geometries: 'uint64_t', parked: 'uint64_t', moved: 'uint64_t', candidatePairs: 'uint64_t', filteredPairs: 'uint64_t',
  examinedPairs: 'uint64_t', keptPairs: 'uint64_t', touchingPairs: 'uint64_t', contacts: 'uint64_t',
  unsupportedPairs: 'uint64_t', events: 'uint64_t', bytes: 'uint64_t', refreshMicroseconds: 'double',
  broadphaseMicroseconds: 'double', pairMicroseconds: 'double', narrowphaseMicroseconds: 'double',
  contactMicroseconds: 'double', asleep: 'uint64_t' });
const finding = koffi.struct('abut_finding', { code: 'uint32_t', reserved: 'uint32_t', geometry: geometryId,
  other: geometryId, message: koffi.array('char', 168) });
const island = koffi.struct('abut_island', { id: 'uint64_t', firstPart: 'uint32_t', partCount: 'uint32_t' });
const velocity = koffi.struct('abut_velocity', { linear: vector, angular: vector });
const acceleration = koffi.struct('abut_acceleration', { linear: vector, angular: vector });
const stepImpact = koffi.struct('abut_step_impact', { geometryA: geometryId, geometryB: geometryId, lower: 'double',
  upper: 'double', firstContact: 'uint32_t', contactCount: 'uint32_t', isUndecided: 'uint32_t', reserved: 'uint32_t' });
const elementContact = koffi.struct('abut_element_contact', { geometryA: geometryId, geometryB: geometryId,
  stencil: stencil, gap: 'double', id: 'uint64_t', age: 'uint32_t', reserved: 'uint32_t' });
const queryFilter = koffi.struct('abut_query_filter', { structSize: 'uint32_t', flags: 'uint32_t', layers: 'uint64_t',
  mask: 'uint64_t', ignorePart: partId, ignoreGeometry: geometryId, rayStart: 'uint32_t', reserved: 'uint32_t' });
const hit = koffi.struct('abut_query_hit', { geometry: geometryId, feature: feature, child: 'uint32_t',
  reserved: 'uint32_t', distance: 'double', point: vector, normal: vector });
const castHit = koffi.struct('abut_cast_hit', { geometry: geometryId, fraction: 'double', contact: distance,
  featureA: feature, featureB: feature, childA: 'uint32_t', childB: 'uint32_t' });
const impactHit = koffi.struct('abut_impact_hit', { geometry: geometryId, impact: impact });
const closest = koffi.struct('abut_closest', { geometry: geometryId, distance: distance });
const layoutEntry = koffi.struct('abut_layout_entry', { type: 'str', field: 'str', offset: 'uint64_t', size: 'uint64_t'
  });
const pick = koffi.struct('abut_pick', { geometry: geometryId, feature: feature, child: 'uint32_t',
  reserved: 'uint32_t', distance: 'double', point: vector, normal: vector });
const camera = koffi.struct('abut_camera', { structSize: 'uint32_t', width: 'uint32_t', height: 'uint32_t',
  projection: 'uint32_t', pose: pose, verticalFov: 'double', nearDistance: 'double', farDistance: 'double',
  verticalExtent: 'double', pixelAspect: 'double', shiftX: 'double', shiftY: 'double', depthAxis: 'uint32_t',
  reserved: 'uint32_t' });
const clipPlane = koffi.struct('abut_clip_plane', { normal: vector, offset: 'double' });
const snap = koffi.struct('abut_snap', { geometry: geometryId, kind: 'uint32_t', vertices: koffi.array('uint32_t', 2),
  reserved: 'uint32_t', parameter: 'double', pixels: 'double', distance: 'double', point: vector });
const barycentric = koffi.struct('abut_barycentric', { triangle: 'uint32_t', vertices: koffi.array('uint32_t', 3),
  weights: koffi.array('double', 3) });
const contactProblem = koffi.struct('abut_contact_problem', { structSize: 'uint32_t', bodyCount: 'uint32_t',
  contactCount: 'uint32_t', reserved: 'uint32_t', masses: 'double *', inertias: 'double *', centres: 'double *',
  freeVelocities: 'double *', bodies: 'uint32_t *', points: 'double *', normals: 'double *', tangents: 'double *',
  frictions: 'double *', compliances: 'double *', offsets: 'double *', surfaceVelocities: 'double *',
  firstVelocities: 'double *', firstImpulses: 'double *' });
const solverOptions = koffi.struct('abut_solver_options', { structSize: 'uint32_t', mostRounds: 'uint32_t',
  tolerance: 'double', speed: 'double', solver: 'uint32_t', reserved: 'uint32_t' });
const residuals = koffi.struct('abut_residuals', { contact: 'double', motion: 'double', dissipation: 'double',
  speed: 'double', rounds: 'uint32_t', newtonSteps: 'uint32_t', isConverged: 'uint32_t', reserved: 'uint32_t' });
const massProperties = koffi.struct('abut_mass_properties', { mass: 'double', centre: vector,
  inertia: koffi.array('double', 9) });
const responseOptions = koffi.struct('abut_response_options', { structSize: 'uint32_t', mostRounds: 'uint32_t',
  gravity: vector, tolerance: 'double', slop: 'double', flags: 'uint32_t', solver: 'uint32_t', threads: 'uint32_t',
  reserved: 'uint32_t' });
const bodyOptions = koffi.struct('abut_body_options', { structSize: 'uint32_t', integrator: 'uint32_t',
  density: 'double', mass: massProperties });
const elasticOptions = koffi.struct('abut_elastic_options', { structSize: 'uint32_t', reserved: 'uint32_t',
  young: 'double', poisson: 'double', damping: 'double' });
const contactLaw = koffi.struct('abut_contact_law', { frictionPrimary: 'double', frictionSecondary: 'double',
  compliance: 'double', offset: 'double', pull: 'double', surfaceVelocity: vector });
const responseSide = koffi.struct('abut_response_side', { kind: 'uint32_t', slot: 'uint32_t', generation: 'uint32_t' });
const linkOptions = koffi.struct('abut_link_options', { structSize: 'uint32_t', reserved: 'uint32_t', a: partId,
  b: partId, pointA: vector, pointB: vector, stiffness: 'double', damping: 'double', mostForce: 'double',
  breakForce: 'double' });
const responseContact = koffi.struct('abut_response_contact', { geometryA: geometryId, geometryB: geometryId,
  id: 'uint64_t', point: vector, normal: vector, impulse: vector, force: vector, distance: 'double',
  normalVelocity: 'double', state: 'uint32_t', island: 'uint32_t', kind: 'uint32_t', reserved: 'uint32_t' });
const responseObject = koffi.struct('abut_response_object', { geometryA: geometryId, geometryB: geometryId,
  kind: 'uint32_t', event: 'uint32_t', contactCount: 'uint32_t', bondCount: 'uint32_t', age: 'uint32_t',
  reserved: 'uint32_t', impulse: vector, force: vector });
const responseIsland = koffi.struct('abut_response_island', { bodyCount: 'uint32_t', contactCount: 'uint32_t',
  integrator: 'uint32_t', reserved: 'uint32_t', residuals: residuals });
const energy = koffi.struct('abut_energy', { kinetic: 'double', potential: 'double', linearMomentum: vector,
  angularMomentum: vector });
const responseFinding = koffi.struct('abut_response_finding', { code: 'uint32_t', rule: 'uint32_t', part: partId,
  geometry: geometryId, message: koffi.array('char', 168) });
koffi.opaque('abut_shape');
koffi.opaque('abut_elements');
koffi.opaque('abut_universe');
koffi.opaque('abut_picker');
koffi.opaque('abut_response');

export const structs = { vector, quaternion, pose, aabb, partId, geometryId, feature, hullReport, meshOptions,
  meshReport, uvGridOptions, heightFieldDesc, distanceFieldDesc, distanceFieldOptions, distanceFieldReport,
  compositeChild, shapeDesc, ray, rayHit, queryOptions, route, distance, contact, pairMemory, firstTouch, elementCounts,
  elementsOptions, stencil, elementPair, crossing, movement, impactOptions, impact, universeOptions, partOptions, sleep,
  geometryOptions, geometryInfo, revision, collidable, policy, focus, contactMaterial, backendPair, backendContact,
  event, sleepChange, localPoints, stepStats, finding, island, velocity, acceleration, stepImpact, elementContact,
  queryFilter, hit, castHit, impactHit, closest, layoutEntry, pick, camera, clipPlane, snap, barycentric,
  contactProblem, solverOptions, residuals, massProperties, responseOptions, bodyOptions, elasticOptions, contactLaw,
  responseSide, linkOptions, responseContact, responseObject, responseIsland, energy, responseFinding };

export const callbacks = {
  log: koffi.pointer(koffi.proto('void abut_log(void *context, uint32_t level, void *message)')),
  allocate: koffi.pointer(koffi.proto('void *abut_allocate(void *context, size_t size, size_t alignment)')),
  release: koffi.pointer(koffi.proto('void abut_release(void *context, void *memory, size_t size, size_t alignment)')),
  filter: koffi.pointer(koffi.proto('uint32_t abut_filter(void *context, void *universe, abut_geometry_id geometry_a, abut_geometry_id geometry_b)')),
  pointerFilter: koffi.pointer(koffi.proto('uint32_t abut_pointer_filter(void *context, void *universe, void *geometry_a, void *geometry_b)')),
  backendAccepts: koffi.pointer(koffi.proto('uint32_t abut_backend_accepts(void *context, uint32_t kind_a, uint32_t kind_b)')),
  backendFind: koffi.pointer(koffi.proto('void abut_backend_find(void *context, void *universe, void *pairs, size_t count)')),
  forceCallback: koffi.pointer(koffi.proto('void abut_force_callback(void *context, abut_part_id part, void *pose, void *velocity, double time, void *force, void *torque)')),
  contactCallback: koffi.pointer(koffi.proto('uint32_t abut_contact_callback(void *context, void *contact, void *material)')),
  contactLawCallback: koffi.pointer(koffi.proto('uint32_t abut_contact_law_callback(void *context, void *contact, void *velocity, double dt, void *law)')),
  responseListener: koffi.pointer(koffi.proto('void abut_response_listener(void *context, void *object)')),
};

export const prototypes = {
  abut: [
    'int32_t abut_set_last_error(int32_t status, const char *message)',
    'const char *abut_status_name(int32_t status)',
    'const char *abut_last_error_message()',
    'int32_t abut_set_log(abut_log *log, void *context, uint32_t most)',
    'const char *abut_version_string()',
    'int32_t abut_check_version(uint32_t major, uint32_t minor)',
    'uint32_t abut_has_feature(const char *name)',
    'int32_t abut_set_allocator(abut_allocate *allocate, abut_release *release, void *context)',
    'int32_t abut_memory_in_use(_Out_ uint64_t *bytes, _Out_ uint64_t *blocks)',
    'void *abut_memory_allocate(size_t size, size_t alignment)',
    'void abut_memory_release(void *memory, size_t size, size_t alignment)',
    'size_t abut_shape_kind_count()',
    'uint32_t abut_shape_kind_at(size_t index)',
    'uint32_t abut_shape_kind_by_name(const char *name)',
    'const char *abut_shape_kind_name(uint32_t kind)',
    'size_t abut_shape_kind_parameter_count(uint32_t kind)',
    'const char *abut_shape_kind_parameter_name(uint32_t kind, size_t index)',
    'int32_t abut_pair_support(uint32_t kind_a, uint32_t kind_b, uint32_t query, _Out_ uint32_t *out)',
    'int32_t abut_sphere_create(double radius, _Out_ abut_shape **out)',
    'int32_t abut_box_create(double half_x, double half_y, double half_z, _Out_ abut_shape **out)',
    'int32_t abut_capsule_create(double radius, double half_height, _Out_ abut_shape **out)',
    'int32_t abut_cylinder_create(double radius, double half_height, _Out_ abut_shape **out)',
    'int32_t abut_cone_create(double radius, double half_height, _Out_ abut_shape **out)',
    'int32_t abut_ellipsoid_create(double radius_x, double radius_y, double radius_z, _Out_ abut_shape **out)',
    'int32_t abut_point_create(_Out_ abut_shape **out)',
    'int32_t abut_segment_create(double half_length, _Out_ abut_shape **out)',
    'int32_t abut_triangle_create(const abut_vec3 *a, const abut_vec3 *b, const abut_vec3 *c, _Out_ abut_shape **out)',
    'int32_t abut_plane_create(const abut_vec3 *normal, double offset, _Out_ abut_shape **out)',
    'int32_t abut_hull_create(const double *xyz, size_t point_count, _Out_ abut_shape **out)',
    'void abut_hull_report_init(_Out_ abut_hull_report *report, uint32_t struct_size)',
    'int32_t abut_hull_describe(abut_shape *shape, _Inout_ abut_hull_report *out)',
    'void abut_mesh_options_init(_Out_ abut_mesh_options *options, uint32_t struct_size)',
    'int32_t abut_mesh_create(const double *xyz, size_t vertex_count, const uint32_t *triangles, size_t triangle_count, const abut_mesh_options *options, _Out_ abut_shape **out)',
    'void abut_mesh_report_init(_Out_ abut_mesh_report *report, uint32_t struct_size)',
    'int32_t abut_mesh_describe(const double *xyz, size_t vertex_count, const uint32_t *triangles, size_t triangle_count, const abut_mesh_options *options, _Inout_ abut_mesh_report *out)',
    'void abut_uv_grid_options_init(_Out_ abut_uv_grid_options *options, uint32_t struct_size)',
    'int32_t abut_uv_grid_create(const double *xyz, size_t vertex_count, const uint32_t *triangles, size_t triangle_count, const abut_uv_grid_options *options, _Out_ abut_shape **out)',
    'void abut_height_field_desc_init(_Out_ abut_height_field_desc *desc, uint32_t struct_size)',
    'int32_t abut_height_field_create(const abut_height_field_desc *desc, _Out_ abut_shape **out)',
    'void abut_distance_field_desc_init(_Out_ abut_distance_field_desc *desc, uint32_t struct_size)',
    'int32_t abut_distance_field_create(const abut_distance_field_desc *desc, _Out_ abut_shape **out)',
    'void abut_distance_field_options_init(_Out_ abut_distance_field_options *options, uint32_t struct_size)',
    'int32_t abut_distance_field_from_mesh(const double *xyz, size_t vertex_count, const uint32_t *triangles, size_t triangle_count, const abut_distance_field_options *options, _Out_ abut_shape **out)',
    'void abut_distance_field_report_init(_Out_ abut_distance_field_report *report, uint32_t struct_size)',
    'int32_t abut_distance_field_describe(abut_shape *shape, _Inout_ abut_distance_field_report *out)',
    'int32_t abut_particles_create(const double *xyz, size_t count, double radius, _Out_ abut_shape **out)',
    'int32_t abut_particles_create_with_radii(const double *xyz, const double *radii, size_t count, _Out_ abut_shape **out)',
    'int32_t abut_composite_create(abut_shape **children, const abut_pose *poses, size_t count, _Out_ abut_shape **out)',
    'int32_t abut_composite_create_with_materials(abut_shape **children, const abut_pose *poses, const uint32_t *materials, size_t count, _Out_ abut_shape **out)',
    'int32_t abut_composite_children(abut_shape *shape, void *children, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_composite_child_shape(abut_shape *shape, uint32_t child, _Out_ abut_shape **out)',
    'int32_t abut_sphere_hole_create(double radius, _Out_ abut_shape **out)',
    'int32_t abut_cylinder_hole_create(double radius, double half_height, uint32_t open_ends, _Out_ abut_shape **out)',
    'int32_t abut_box_hole_create(double half_x, double half_y, double half_z, uint32_t open_faces, _Out_ abut_shape **out)',
    'void abut_shape_desc_init(_Out_ abut_shape_desc *desc, uint32_t struct_size)',
    'int32_t abut_shape_create(const abut_shape_desc *desc, _Out_ abut_shape **out)',
    'void abut_shape_retain(abut_shape *shape)',
    'void abut_shape_release(abut_shape *shape)',
    'uint32_t abut_shape_kind_of(abut_shape *shape)',
    'int32_t abut_shape_parameters(abut_shape *shape, void *parameters, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_shape_aabb(abut_shape *shape, const abut_pose *pose, _Out_ abut_aabb *out)',
    'int32_t abut_shape_triangles(abut_shape *shape, void *xyz, size_t vertex_capacity, _Out_ size_t *vertex_count, void *triangles, size_t triangle_capacity, _Out_ size_t *triangle_count)',
    'int32_t abut_shape_prepare(abut_shape *shape, uint32_t threads)',
    'int32_t abut_shape_cast_ray(abut_shape *shape, const abut_pose *pose, const abut_ray *ray, _Out_ abut_ray_hit *hit, _Out_ uint32_t *found)',
    'void abut_query_options_init(_Out_ abut_query_options *options, uint32_t struct_size)',
    'int32_t abut_pair_routes(uint32_t kind_a, uint32_t kind_b, uint32_t query, const abut_query_options *options, void *routes, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_routes_load(const char *text)',
    'int32_t abut_contact_validate(const abut_contact *contact)',
    'int32_t abut_pair_distance(abut_shape *a, const abut_pose *pose_a, abut_shape *b, const abut_pose *pose_b, const abut_query_options *options, _Out_ abut_distance *out)',
    'int32_t abut_pairs_distance(abut_shape *a, const abut_pose *poses_a, abut_shape *b, const abut_pose *poses_b, size_t count, const abut_query_options *options, void *out)',
    'int32_t abut_pair_contacts(abut_shape *a, const abut_pose *pose_a, abut_shape *b, const abut_pose *pose_b, const abut_query_options *options, void *contacts, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_pair_distance_with_memory(abut_shape *a, const abut_pose *pose_a, abut_shape *b, const abut_pose *pose_b, const abut_query_options *options, _Inout_ abut_pair_memory *memory, _Out_ abut_distance *out)',
    'int32_t abut_pairs_distance_with_memories(abut_shape *a, const abut_pose *poses_a, abut_shape *b, const abut_pose *poses_b, size_t count, const abut_query_options *options, void *memories, void *out)',
    'int32_t abut_pairs_contacts(abut_shape *a, const abut_pose *poses_a, abut_shape *b, const abut_pose *poses_b, size_t pair_count, const abut_query_options *options, void *offsets, void *contacts, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_pair_contacts_with_memory(abut_shape *a, const abut_pose *pose_a, abut_shape *b, const abut_pose *pose_b, const abut_query_options *options, _Inout_ abut_pair_memory *memory, void *contacts, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_pairs_contacts_with_memories(abut_shape *a, const abut_pose *poses_a, abut_shape *b, const abut_pose *poses_b, size_t pair_count, const abut_query_options *options, void *memories, void *offsets, void *contacts, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_pair_overlaps(abut_shape *a, const abut_pose *pose_a, abut_shape *b, const abut_pose *pose_b, const abut_query_options *options, _Out_ uint32_t *out)',
    'int32_t abut_pairs_overlap(abut_shape **shapes_a, const abut_pose *poses_a, abut_shape **shapes_b, const abut_pose *poses_b, size_t count, const abut_query_options *options, void *out)',
    'int32_t abut_vertices_touch_faces(const double *start, const double *end, size_t count, double separation, double tolerance, void *out)',
    'int32_t abut_edges_touch_edges(const double *start, const double *end, size_t count, double separation, double tolerance, void *out)',
    'int32_t abut_elements_create(abut_shape *shape, _Out_ abut_elements **out)',
    'void abut_elements_destroy(abut_elements *elements)',
    'int32_t abut_elements_count(abut_elements *elements, _Out_ abut_element_counts *out)',
    'int32_t abut_elements_edges(abut_elements *elements, void *vertices, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_elements_set_vertices(abut_elements *elements, const double *start, const double *end, size_t vertex_count)',
    'void abut_elements_options_init(_Out_ abut_elements_options *options, uint32_t struct_size)',
    'int32_t abut_elements_candidates(abut_elements *a, abut_elements *b, const abut_elements_options *options, void *pairs, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_elements_closest(abut_elements *a, abut_elements *b, const abut_elements_options *options, void *stencils, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_elements_first_touches(abut_elements *a, abut_elements *b, const abut_elements_options *options, void *stencils, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_elements_crossings(abut_elements *a, abut_elements *b, const abut_elements_options *options, void *crossings, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_movement_between(const abut_pose *start, const abut_pose *end, const abut_vec3 *centre, double duration, _Out_ abut_movement *out)',
    'void abut_impact_options_init(_Out_ abut_impact_options *options, uint32_t struct_size)',
    'int32_t abut_pair_time_of_impact(abut_shape *a, const abut_pose *pose_a, const abut_movement *movement_a, abut_shape *b, const abut_pose *pose_b, const abut_movement *movement_b, double duration, const abut_impact_options *options, _Out_ abut_impact *out)',
    'int32_t abut_pairs_time_of_impact(abut_shape *a, const abut_pose *poses_a, const abut_movement *movements_a, abut_shape *b, const abut_pose *poses_b, const abut_movement *movements_b, size_t count, double duration, const abut_impact_options *options, void *out)',
    'void abut_universe_options_init(_Out_ abut_universe_options *options, uint32_t struct_size)',
    'int32_t abut_universe_create(const abut_universe_options *options, _Out_ abut_universe **out)',
    'void abut_universe_destroy(abut_universe *universe)',
    'int32_t abut_universe_save(abut_universe *universe, void *bytes, size_t capacity, _Out_ size_t *size)',
    'int32_t abut_universe_load(const void *bytes, size_t size, _Out_ abut_universe **out)',
    'void abut_part_options_init(_Out_ abut_part_options *options, uint32_t struct_size)',
    'int32_t abut_part_create(abut_universe *universe, const abut_part_options *options, _Out_ abut_part_id *out)',
    'int32_t abut_parts_create(abut_universe *universe, const abut_part_options *options, size_t count, void *out)',
    'int32_t abut_part_destroy(abut_universe *universe, abut_part_id part)',
    'int32_t abut_parts_destroy(abut_universe *universe, const abut_part_id *parts, size_t count)',
    'int32_t abut_part_set_pose(abut_universe *universe, abut_part_id part, const abut_pose *pose)',
    'int32_t abut_parts_set_poses(abut_universe *universe, const abut_part_id *parts, const abut_pose *poses, size_t count)',
    'int32_t abut_part_pose(abut_universe *universe, abut_part_id part, _Out_ abut_pose *out)',
    'int32_t abut_parts_poses(abut_universe *universe, const abut_part_id *parts, size_t count, void *out)',
    'int32_t abut_part_set_motion(abut_universe *universe, abut_part_id part, uint32_t motion)',
    'int32_t abut_parts_set_motions(abut_universe *universe, const abut_part_id *parts, const uint32_t *motions, size_t count)',
    'int32_t abut_part_motion(abut_universe *universe, abut_part_id part, _Out_ uint32_t *out)',
    'int32_t abut_part_user_data(abut_universe *universe, abut_part_id part, _Out_ uint64_t *out)',
    'int32_t abut_part_set_user_data(abut_universe *universe, abut_part_id part, uint64_t user_data)',
    'int32_t abut_parts_set_user_data(abut_universe *universe, const abut_part_id *parts, const uint64_t *user_data, size_t count)',
    'int32_t abut_part_geometries(abut_universe *universe, abut_part_id part, void *geometries, size_t capacity, _Out_ size_t *count)',
    'void abut_sleep_init(_Out_ abut_sleep *sleep, uint32_t struct_size)',
    'int32_t abut_part_set_sleep(abut_universe *universe, abut_part_id part, const abut_sleep *sleep)',
    'int32_t abut_parts_set_sleep(abut_universe *universe, const abut_part_id *parts, const abut_sleep *sleeps, size_t count)',
    'int32_t abut_part_is_asleep(abut_universe *universe, abut_part_id part, _Out_ uint32_t *out)',
    'int32_t abut_part_wake(abut_universe *universe, abut_part_id part)',
    'int32_t abut_parts_wake(abut_universe *universe, const abut_part_id *parts, size_t count)',
    'void abut_geometry_options_init(_Out_ abut_geometry_options *options, uint32_t struct_size)',
    'int32_t abut_geometry_create(abut_universe *universe, abut_part_id part, abut_shape *shape, const abut_geometry_options *options, _Out_ abut_geometry_id *out)',
    'int32_t abut_geometries_create(abut_universe *universe, const abut_part_id *parts, abut_shape **shapes, const abut_geometry_options *options, size_t count, void *out)',
    'int32_t abut_geometry_destroy(abut_universe *universe, abut_geometry_id geometry)',
    'int32_t abut_geometries_destroy(abut_universe *universe, const abut_geometry_id *geometries, size_t count)',
    'int32_t abut_geometry_set_options(abut_universe *universe, abut_geometry_id geometry, const abut_geometry_options *options)',
    'int32_t abut_geometries_set_options(abut_universe *universe, const abut_geometry_id *geometries, const abut_geometry_options *options, size_t count)',
    'int32_t abut_geometry_set_user_data(abut_universe *universe, abut_geometry_id geometry, uint64_t user_data)',
    'int32_t abut_geometries_set_user_data(abut_universe *universe, const abut_geometry_id *geometries, const uint64_t *user_data, size_t count)',
    'int32_t abut_geometry_set_shape(abut_universe *universe, abut_geometry_id geometry, abut_shape *shape)',
    'int32_t abut_geometries_set_shapes(abut_universe *universe, const abut_geometry_id *geometries, abut_shape **shapes, size_t count)',
    'int32_t abut_geometry_set_parameters(abut_universe *universe, abut_geometry_id geometry, const double *parameters, size_t parameter_count)',
    'int32_t abut_geometries_set_parameters(abut_universe *universe, const abut_geometry_id *geometries, const double *parameters, size_t parameter_count, size_t count)',
    'int32_t abut_geometry_set_heights(abut_universe *universe, abut_geometry_id geometry, uint32_t column, uint32_t row, uint32_t columns, uint32_t rows, const double *heights)',
    'int32_t abut_geometry_set_field_values(abut_universe *universe, abut_geometry_id geometry, uint32_t column, uint32_t row, uint32_t layer, uint32_t columns, uint32_t rows, uint32_t layers, const double *values)',
    'int32_t abut_geometry_set_field_lattice(abut_universe *universe, abut_geometry_id geometry, uint32_t columns, uint32_t rows, uint32_t layers, const double *xyz)',
    'int32_t abut_geometry_set_particles(abut_universe *universe, abut_geometry_id geometry, size_t first, const double *xyz, const double *radii, size_t count)',
    'int32_t abut_geometry_set_vertices(abut_universe *universe, abut_geometry_id geometry, size_t first, const double *xyz, size_t count)',
    'int32_t abut_geometry_set_vertices_at(abut_universe *universe, abut_geometry_id geometry, const uint32_t *vertices, const double *xyz, size_t count)',
    'int32_t abut_geometry_vertices(abut_universe *universe, abut_geometry_id geometry, _Out_ void **xyz, _Out_ size_t *count)',
    'int32_t abut_geometry_next_vertices(abut_universe *universe, abut_geometry_id geometry, _Out_ void **xyz, _Out_ size_t *count)',
    'int32_t abut_geometry_advance(abut_universe *universe, abut_geometry_id geometry)',
    'int32_t abut_geometries_advance(abut_universe *universe, const abut_geometry_id *geometries, size_t count)',
    'int32_t abut_geometry_remove_triangles(abut_universe *universe, abut_geometry_id geometry, const uint32_t *triangles, size_t count)',
    'int32_t abut_geometry_set_mesh(abut_universe *universe, abut_geometry_id geometry, const double *xyz, size_t vertex_count, const uint32_t *triangles, size_t triangle_count)',
    'int32_t abut_geometry_shape(abut_universe *universe, abut_geometry_id geometry, _Out_ abut_shape **out)',
    'int32_t abut_geometry_park(abut_universe *universe, abut_geometry_id geometry, uint32_t parking)',
    'int32_t abut_geometries_park(abut_universe *universe, const abut_geometry_id *geometries, size_t count, uint32_t parking)',
    'void abut_geometry_info_init(_Out_ abut_geometry_info *info, uint32_t struct_size)',
    'int32_t abut_geometry_describe(abut_universe *universe, abut_geometry_id geometry, _Inout_ abut_geometry_info *out)',
    'int32_t abut_geometries_poses(abut_universe *universe, const abut_geometry_id *geometries, size_t count, void *out)',
    'int32_t abut_universe_parts(abut_universe *universe, void *parts, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_universe_geometries(abut_universe *universe, void *geometries, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_universe_revision(abut_universe *universe, _Out_ abut_revision *out)',
    'int32_t abut_universe_counters(abut_universe *universe, _Out_ void **geometries, _Out_ void **poses)',
    'int32_t abut_universe_changes(abut_universe *universe, const abut_revision *since, void *geometries, size_t capacity, _Out_ size_t *count, _Out_ uint32_t *is_known)',
    'int32_t abut_rule_set(abut_universe *universe, const abut_collidable *a, const abut_collidable *b, uint32_t rule)',
    'int32_t abut_rules_clear(abut_universe *universe)',
    'int32_t abut_rule_between(abut_universe *universe, abut_geometry_id geometry_a, abut_geometry_id geometry_b, _Out_ uint32_t *rule, _Out_ abut_collidable *a, _Out_ abut_collidable *b)',
    'int32_t abut_universe_set_filter(abut_universe *universe, abut_filter *filter, void *context)',
    'int32_t abut_universe_set_pointer_filter(abut_universe *universe, abut_pointer_filter *filter, void *context)',
    'int32_t abut_universe_refilter(abut_universe *universe)',
    'void abut_policy_init(_Out_ abut_policy *policy, uint32_t struct_size)',
    'int32_t abut_policy_set(abut_universe *universe, uint32_t tag_a, uint32_t tag_b, const abut_policy *policy)',
    'int32_t abut_policy_get(abut_universe *universe, uint32_t tag_a, uint32_t tag_b, _Inout_ abut_policy *out)',
    'void abut_focus_init(_Out_ abut_focus *focus, uint32_t struct_size)',
    'int32_t abut_universe_set_focus(abut_universe *universe, const abut_focus *focus, const abut_vec3 *centres, size_t count)',
    'void abut_contact_material_init(_Out_ abut_contact_material *material, uint32_t struct_size)',
    'int32_t abut_material_pair_set(abut_universe *universe, uint32_t material_a, uint32_t material_b, const abut_contact_material *row)',
    'int32_t abut_material_pair_get(abut_universe *universe, uint32_t material_a, uint32_t material_b, _Inout_ abut_contact_material *out)',
    'int32_t abut_backend_set(abut_universe *universe, abut_backend_accepts *accepts, abut_backend_find *find, void *context)',
    'int32_t abut_backend_answer(abut_universe *universe, size_t pair, const abut_backend_contact *contacts, size_t count)',
    'int32_t abut_universe_step(abut_universe *universe, double dt)',
    'int32_t abut_universe_detect_all(abut_universe *universe)',
    'int32_t abut_universe_detect_changed(abut_universe *universe)',
    'int32_t abut_universe_detect_pairs(abut_universe *universe, const abut_geometry_id *a, const abut_geometry_id *b, size_t count)',
    'int32_t abut_universe_detect_region(abut_universe *universe, const abut_aabb *region)',
    'int32_t abut_universe_refresh(abut_universe *universe)',
    'int32_t abut_universe_events(abut_universe *universe, _Out_ void **events, _Out_ size_t *count)',
    'int32_t abut_universe_sleep_changes(abut_universe *universe, _Out_ void **changes, _Out_ size_t *count)',
    'int32_t abut_universe_hash(abut_universe *universe, _Out_ uint64_t *out)',
    'int32_t abut_universe_contacts(abut_universe *universe, _Out_ void **contacts, _Out_ size_t *count)',
    'int32_t abut_universe_local_points(abut_universe *universe, _Out_ void **points, _Out_ size_t *count)',
    'int32_t abut_contacts_set_user_data(abut_universe *universe, const uint64_t *user_data, size_t count)',
    'void abut_step_stats_init(_Out_ abut_step_stats *stats, uint32_t struct_size)',
    'int32_t abut_universe_stats(abut_universe *universe, _Inout_ abut_step_stats *out)',
    'int32_t abut_universe_explain(abut_universe *universe, void *text, size_t capacity, _Out_ size_t *needed)',
    'int32_t abut_universe_explain_json(abut_universe *universe, void *text, size_t capacity, _Out_ size_t *needed)',
    'int32_t abut_universe_why_apart(abut_universe *universe, abut_geometry_id geometry_a, abut_geometry_id geometry_b, _Out_ uint32_t *out)',
    'int32_t abut_universe_validate(abut_universe *universe, void *findings, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_universe_follow_islands(abut_universe *universe, uint32_t are_followed)',
    'int32_t abut_universe_islands(abut_universe *universe, _Out_ void **islands, _Out_ size_t *count)',
    'int32_t abut_universe_island_parts(abut_universe *universe, _Out_ void **parts, _Out_ size_t *count)',
    'int32_t abut_part_island(abut_universe *universe, abut_part_id part, _Out_ abut_island *out)',
    'int32_t abut_part_set_velocity(abut_universe *universe, abut_part_id part, const abut_velocity *velocity)',
    'int32_t abut_parts_set_velocities(abut_universe *universe, const abut_part_id *parts, const abut_velocity *velocities, size_t count)',
    'int32_t abut_part_measure_velocity(abut_universe *universe, abut_part_id part)',
    'int32_t abut_parts_measure_velocities(abut_universe *universe, const abut_part_id *parts, size_t count)',
    'int32_t abut_part_velocity(abut_universe *universe, abut_part_id part, _Out_ abut_velocity *out, _Out_ uint32_t *source)',
    'int32_t abut_parts_velocities(abut_universe *universe, const abut_part_id *parts, size_t count, void *out)',
    'int32_t abut_part_set_acceleration(abut_universe *universe, abut_part_id part, const abut_acceleration *acceleration)',
    'int32_t abut_parts_set_accelerations(abut_universe *universe, const abut_part_id *parts, const abut_acceleration *accelerations, size_t count)',
    'int32_t abut_parts_accelerations(abut_universe *universe, const abut_part_id *parts, size_t count, void *out)',
    'int32_t abut_universe_impacts(abut_universe *universe, _Out_ void **impacts, _Out_ size_t *count)',
    'int32_t abut_universe_advance_to_first_impact(abut_universe *universe, double dt, _Out_ abut_step_impact *out)',
    'int32_t abut_universe_element_contacts(abut_universe *universe, _Out_ void **contacts, _Out_ size_t *count)',
    'int32_t abut_universe_attach(abut_universe *universe, const char *name)',
    'int32_t abut_universe_detach(abut_universe *universe, const char *name)',
    'void abut_query_filter_init(_Out_ abut_query_filter *filter, uint32_t struct_size)',
    'int32_t abut_universe_cast_ray(abut_universe *universe, const abut_ray *ray, const abut_query_filter *filter, uint32_t mode, void *hits, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_universe_cast_rays(abut_universe *universe, const abut_ray *rays, size_t count, const abut_query_filter *filter, void *hits)',
    'int32_t abut_universe_cast_shape(abut_universe *universe, abut_shape *shape, const abut_pose *pose, const abut_vec3 *displacement, const abut_query_filter *filter, uint32_t mode, void *hits, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_universe_cast_shapes(abut_universe *universe, abut_shape **shapes, const abut_pose *poses, const abut_vec3 *displacements, size_t count, const abut_query_filter *filter, void *hits)',
    'int32_t abut_universe_cast_movement(abut_universe *universe, abut_shape *shape, const abut_pose *pose, const abut_movement *movement, double duration, const abut_impact_options *options, const abut_query_filter *filter, uint32_t mode, void *hits, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_universe_cast_movements(abut_universe *universe, abut_shape **shapes, const abut_pose *poses, const abut_movement *movements, size_t count, double duration, const abut_impact_options *options, const abut_query_filter *filter, void *hits)',
    'int32_t abut_universe_overlaps(abut_universe *universe, abut_shape *shape, const abut_pose *pose, const abut_query_filter *filter, double margin, void *geometries, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_universe_overlaps_of_each(abut_universe *universe, abut_shape **shapes, const abut_pose *poses, size_t query_count, const abut_query_filter *filter, double margin, void *offsets, void *geometries, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_universe_at_point(abut_universe *universe, const abut_vec3 *position, const abut_query_filter *filter, void *geometries, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_universe_at_points(abut_universe *universe, const abut_vec3 *positions, size_t query_count, const abut_query_filter *filter, void *offsets, void *geometries, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_universe_closest(abut_universe *universe, abut_shape *shape, const abut_pose *pose, double max_distance, const abut_query_filter *filter, _Out_ abut_closest *out, _Out_ uint32_t *found)',
    'int32_t abut_universe_closest_to_each(abut_universe *universe, abut_shape **shapes, const abut_pose *poses, size_t count, double max_distance, const abut_query_filter *filter, void *out)',
    'int32_t abut_pair_cast(abut_shape *a, const abut_pose *pose_a, const abut_vec3 *displacement_a, abut_shape *b, const abut_pose *pose_b, const abut_vec3 *displacement_b, const abut_query_options *options, _Out_ abut_cast_hit *hit, _Out_ uint32_t *found)',
    'int32_t abut_pairs_cast(abut_shape *a, const abut_pose *poses_a, const abut_vec3 *displacements_a, abut_shape *b, const abut_pose *poses_b, const abut_vec3 *displacements_b, size_t count, const abut_query_options *options, void *hits)',
    'size_t abut_layout_count()',
    'int32_t abut_layout_at(size_t index, _Out_ abut_layout_entry *out)',
  ],
  picking: [
    'void abut_camera_init(_Out_ abut_camera *camera, uint32_t struct_size)',
    'int32_t abut_camera_look_at(_Inout_ abut_camera *camera, const abut_vec3 *eye, const abut_vec3 *target, const abut_vec3 *up)',
    'int32_t abut_camera_set_projection(_Inout_ abut_camera *camera, const double *matrix, uint32_t depth)',
    'int32_t abut_camera_ray(const abut_camera *camera, double x, double y, _Out_ abut_ray *out)',
    'int32_t abut_picker_create(abut_universe *universe, _Out_ abut_picker **out)',
    'void abut_picker_destroy(abut_picker *picker)',
    'int32_t abut_picker_update(abut_picker *picker)',
    'int32_t abut_picker_set_flags(abut_picker *picker, uint32_t flags)',
    'int32_t abut_picker_set_clip_planes(abut_picker *picker, const abut_clip_plane *planes, size_t count)',
    'int32_t abut_picker_cast_ray(abut_picker *picker, const abut_ray *ray, const abut_query_filter *filter, _Out_ abut_pick *out)',
    'int32_t abut_picker_cast_rays(abut_picker *picker, const abut_ray *rays, size_t count, uint32_t coherence, const abut_query_filter *filter, void *out)',
    'int32_t abut_picker_ray_hits(abut_picker *picker, const abut_ray *ray, const abut_query_filter *filter, _Out_ uint32_t *out)',
    'int32_t abut_picker_rays_hit(abut_picker *picker, const abut_ray *rays, size_t count, uint32_t coherence, const abut_query_filter *filter, void *out)',
    'int32_t abut_picker_cast_ray_all(abut_picker *picker, const abut_ray *ray, const abut_query_filter *filter, void *picks, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_picker_pick_pixel(abut_picker *picker, const abut_camera *camera, double x, double y, double radius, const abut_query_filter *filter, _Out_ abut_pick *out)',
    'int32_t abut_picker_render(abut_picker *picker, const abut_camera *camera, const abut_query_filter *filter, void *out, size_t capacity)',
    'int32_t abut_picker_select_rectangle(abut_picker *picker, const abut_camera *camera, double x0, double y0, double x1, double y1, uint32_t selection, const abut_query_filter *filter, void *geometries, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_picker_snap(abut_picker *picker, const abut_camera *camera, double x, double y, double radius, uint32_t kinds, const abut_query_filter *filter, _Out_ abut_snap *out)',
    'int32_t abut_picker_barycentric(abut_picker *picker, abut_geometry_id geometry, uint32_t face, const abut_vec3 *point, _Out_ abut_barycentric *out)',
  ],
  response: [
    'void abut_contact_problem_init(_Out_ abut_contact_problem *problem, uint32_t struct_size)',
    'void abut_solver_options_init(_Out_ abut_solver_options *options, uint32_t struct_size)',
    'int32_t abut_contact_problem_solve(const abut_contact_problem *problem, const abut_solver_options *options, _Out_ double *velocities, _Out_ double *impulses, _Out_ abut_residuals *out)',
    'int32_t abut_shape_mass_properties(abut_shape *shape, double density, _Out_ abut_mass_properties *out)',
    'void abut_response_options_init(_Out_ abut_response_options *options, uint32_t struct_size)',
    'int32_t abut_response_create(abut_universe *universe, const abut_response_options *options, _Out_ abut_response **out)',
    'void abut_response_destroy(abut_response *response)',
    'int32_t abut_response_set_options(abut_response *response, const abut_response_options *options)',
    'void abut_body_options_init(_Out_ abut_body_options *options, uint32_t struct_size)',
    'int32_t abut_response_add_bodies(abut_response *response, const abut_part_id *parts, size_t count, const abut_body_options *options)',
    'int32_t abut_response_remove_body(abut_response *response, abut_part_id part)',
    'int32_t abut_response_body(abut_response *response, abut_part_id part, _Out_ abut_mass_properties *out)',
    'int32_t abut_response_apply_force(abut_response *response, abut_part_id part, const abut_vec3 *force, const abut_vec3 *at)',
    'int32_t abut_response_apply_torque(abut_response *response, abut_part_id part, const abut_vec3 *torque)',
    'int32_t abut_response_set_force_callback(abut_response *response, abut_force_callback *callback, void *context)',
    'int32_t abut_response_add_particles(abut_response *response, abut_geometry_id geometry, const double *masses, const double *xyz, const double *velocities, size_t count)',
    'int32_t abut_response_add_springs(abut_response *response, abut_geometry_id geometry, const uint32_t *pairs, const double *stiffnesses, const double *dampings, const double *rest_lengths, size_t count)',
    'void abut_elastic_options_init(_Out_ abut_elastic_options *options, uint32_t struct_size)',
    'int32_t abut_response_add_tetrahedra(abut_response *response, abut_geometry_id geometry, const uint32_t *tetrahedra, size_t count, const abut_elastic_options *options)',
    'int32_t abut_response_map_vertices(abut_response *response, abut_geometry_id surface, abut_geometry_id carrier, const uint32_t *numbers, const double *weights, size_t count)',
    'int32_t abut_response_remove_particles(abut_response *response, abut_geometry_id geometry)',
    'int32_t abut_response_particles(abut_response *response, abut_geometry_id geometry, _Out_ void **xyz, _Out_ void **velocities, _Out_ size_t *count)',
    'int32_t abut_response_set_contact_callback(abut_response *response, abut_contact_callback *callback, void *context)',
    'int32_t abut_response_add_kind(abut_response *response, const char *name, abut_contact_law_callback *law, void *context)',
    'int32_t abut_response_kinds(abut_response *response, const void *names, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_response_add_rule(abut_response *response, const abut_response_side *a, const abut_response_side *b, const char *kind, const char *parameters, _Out_ uint32_t *out)',
    'int32_t abut_response_set_rule_parameters(abut_response *response, uint32_t rule, const char *parameters)',
    'int32_t abut_response_clear_rules(abut_response *response)',
    'int32_t abut_response_set_variable(abut_response *response, const char *name, const char *value)',
    'int32_t abut_response_set_geometry_kind(abut_response *response, abut_geometry_id geometry, const char *kind, const char *parameters)',
    'int32_t abut_response_rule_between(abut_response *response, abut_geometry_id a, abut_geometry_id b, void *text, size_t capacity, _Out_ size_t *needed)',
    'void abut_link_options_init(_Out_ abut_link_options *options, uint32_t struct_size)',
    'int32_t abut_response_add_link(abut_response *response, const abut_link_options *options, _Out_ uint64_t *out)',
    'int32_t abut_response_move_link(abut_response *response, uint64_t link, const abut_vec3 *point_a)',
    'int32_t abut_response_link_force(abut_response *response, uint64_t link, _Out_ abut_vec3 *out)',
    'int32_t abut_response_remove_link(abut_response *response, uint64_t link)',
    'int32_t abut_response_release(abut_response *response, abut_geometry_id a, abut_geometry_id b)',
    'int32_t abut_response_step(abut_response *response, double dt)',
    'int32_t abut_response_contacts(abut_response *response, _Out_ void **contacts, _Out_ size_t *count)',
    'int32_t abut_response_objects(abut_response *response, _Out_ void **objects, _Out_ size_t *count)',
    'int32_t abut_response_set_listener(abut_response *response, abut_response_listener *listener, void *context)',
    'int32_t abut_response_islands(abut_response *response, _Out_ void **islands, _Out_ size_t *count)',
    'int32_t abut_response_energy(abut_response *response, _Out_ abut_energy *out)',
    'int32_t abut_response_validate(abut_response *response, void *findings, size_t capacity, _Out_ size_t *count)',
    'int32_t abut_response_explain(abut_response *response, void *text, size_t capacity, _Out_ size_t *needed)',
    'int32_t abut_response_explain_json(abut_response *response, void *text, size_t capacity, _Out_ size_t *needed)',
    'int32_t abut_response_save(abut_response *response, void *bytes, size_t capacity, _Out_ size_t *size)',
    'int32_t abut_response_load(abut_universe *universe, const void *bytes, size_t size, _Out_ abut_response **out)',
    'int32_t abut_response_hash(abut_response *response, _Out_ uint64_t *out)',
  ],
};

export const version = { major: 0, minor: 2 };
