# Runs in a headless engine: godot --headless --path PROJECT --script res://test_engine.gd
# SPDX-License-Identifier: MIT
extends SceneTree

var passed := 0
var failed := 0


func check(ok: bool, what: String) -> void:
	if ok:
		passed += 1
	else:
		failed += 1
		print("FAILED: ", what)


func near(a: float, b: float, tolerance: float) -> bool:
	return absf(a - b) <= tolerance


func _initialize() -> void:
	await process_frame
	for test in get_method_list():
		if test.name.begins_with("test_"):
			await call(test.name)
	print("engine: %d passed, %d failed" % [passed, failed])
	quit(1 if failed > 0 else 0)


func make_world(process := LangevinWorld.PROCESS_CALLBACK_MANUAL) -> LangevinWorld:
	var world := LangevinWorld.new()
	world.process_callback = process
	world.seed = 7
	root.add_child(world)
	return world


func make_batch(world: LangevinWorld, count: int, capacity := 0) -> LangevinBatch:
	var batch := LangevinBatch.new()
	batch.asset = load("res://leaf.lrb")
	batch.mesh = BoxMesh.new()
	batch.capacity = maxi(capacity, maxi(count, 1))
	batch.initial_count = count
	batch.emission_rate = 0.0
	batch.emission_extents = Vector3(2, 1, 2)
	batch.position = Vector3(0, 10, 0)
	world.add_child(batch)
	return batch


func floor_at(height: float, shape: Shape3D = null) -> StaticBody3D:
	var body := StaticBody3D.new()
	var collision := CollisionShape3D.new()
	collision.shape = shape if shape else WorldBoundaryShape3D.new()
	body.position.y = height
	body.add_child(collision)
	root.add_child(body)
	return body


func transform_of_row(rows: PackedFloat32Array, body: int) -> Transform3D:
	var r := rows.slice(12 * body, 12 * body + 12)
	return Transform3D(
		Vector3(r[0], r[4], r[8]), Vector3(r[1], r[5], r[9]), Vector3(r[2], r[6], r[10]), Vector3(r[3], r[7], r[11])
	)


# ----------------------------------------------------------------------------------------------------------------------


func test_asset() -> void:
	var asset: LangevinAsset = load("res://leaf.lrb")
	check(asset != null and asset.is_valid(), "the loader knows .lrb")
	check(asset.resource_path == "res://leaf.lrb", "a loaded asset has its path")
	check(near(asset.get_mass(), 0.00018, 0.00002), "mass of the leaf")
	check(near(asset.get_density(), 350.0, 0.1), "density of the leaf")
	check(asset == load("res://leaf.lrb"), "loaded once")
	check("lrb" in ResourceLoader.get_recognized_extensions_for_type("LangevinAsset"), "extension is recognised")
	check(ResourceLoader.exists("res://leaf.lrb"), "exists")
	var again := LangevinAsset.new()
	check(not again.is_valid() and again.get_mass() == 0.0, "a new asset is empty")
	check(again.load_bytes(FileAccess.get_file_as_bytes("res://leaf.lrb")) == OK, "from bytes")
	check(again.get_content_hash() == asset.get_content_hash(), "the same contents")
	check(ResourceSaver.save(again, "user://embedded.tres") == OK, "saved as text")
	var stored: LangevinAsset = load("user://embedded.tres")
	check(stored.get_content_hash() == asset.get_content_hash(), "stored in a text resource")
	var disc := LangevinAsset.new()
	check(disc.make_ellipsoid(Vector3(0.02, 0.02, 0.0005), 500.0) == OK and disc.is_valid(), "ellipsoid")
	print("refused assets (4 expected)")
	check(disc.make_ellipsoid(Vector3(-1, 1, 1), 500.0) == ERR_INVALID_PARAMETER and disc.is_valid(), "bad ellipsoid")
	var bytes := FileAccess.get_file_as_bytes("res://leaf.lrb")
	bytes[bytes.size() / 2] ^= 0x55
	check(disc.load_bytes(bytes) == ERR_FILE_CORRUPT and disc.is_valid(), "damaged bytes are refused, the old ones stay")
	check(disc.load_file("res://nothing.lrb") == ERR_FILE_NOT_FOUND, "no such file")


func test_bodies_and_transforms() -> void:
	var world := make_world()
	var batch := make_batch(world, 200)
	for i in 30:
		world.step(1.0 / 60.0)
	check(batch.get_body_count() == 200 and world.get_body_count() == 200, "200 bodies")
	check(near(world.get_time(), 0.5, 1e-6), "half a second")
	var ids := batch.get_bodies()
	var rows := batch.get_transforms()
	var drawn := batch.get_instance_buffer()
	var positions := batch.get_positions()
	check(rows.size() == 2400 and ids.size() == 200 and positions.size() == 200, "sizes of arrays")
	check(drawn.size() >= 2400 and drawn.slice(0, 2400) == rows, "what is drawn is what there is")
	var worst := 0.0
	for i in 200:
		var t := batch.get_body_transform(ids[i])
		var r := transform_of_row(rows, i)
		worst = maxf(worst, maxf((t.origin - r.origin).length(), (t.basis.x - r.basis.x).length()))
		worst = maxf(worst, (t.basis.y - r.basis.y).length() + (t.basis.z - r.basis.z).length())
		check(positions[i] == r.origin, "position %d" % i)
	check(worst < 1e-5, "states agree with rows to %.7f" % worst)
	check(rows[7] < 11.0 and rows[7] > 4.0, "they are where the emitter is, less the fall")
	var speed := batch.get_body_linear_velocity(ids[0])
	check(speed.y < -0.1 and speed.y > -5.0, "they fall")
	check(near(batch.get_body_age(ids[0]), 0.5, 1e-4), "age")
	check(batch.destroy_bodies(ids.slice(0, 50)) == OK and batch.get_body_count() == 150, "destroyed")
	check(not batch.has_body(ids[0]) and batch.has_body(ids[60]), "stale ids are known")
	print("refused calls (2 expected)")
	check(batch.destroy_bodies(ids.slice(0, 1)) == FAILED, "destroyed twice")
	check(batch.emit(100) == FAILED and batch.get_body_count() == 150, "no room")
	batch.clear()
	check(batch.get_body_count() == 0, "clear")
	world.free()


func test_spawn_and_forces() -> void:
	var world := make_world()
	world.gravity = Vector3.ZERO
	var batch := make_batch(world, 0, 8)
	var pose := Transform3D(Basis(Vector3(1, 2, 3).normalized(), 0.7).scaled(Vector3.ONE * 2.0), Vector3(1, 2, 3))
	var body := batch.spawn(pose, Vector3(0, 0, 0), Vector3.ZERO)
	check(batch.has_body(body) and batch.get_body_transform(body).is_equal_approx(pose), "spawned where told, at scale 2")
	batch.add_velocity(body, Vector3(3, 0, 0), Vector3.ZERO)
	check(batch.get_body_linear_velocity(body).is_equal_approx(Vector3(3, 0, 0)), "velocity added")
	world.step(1.0 / 60.0)
	check(batch.get_body_transform(body).origin.x > 1.01, "it moves")
	pose.origin = Vector3(9, 9, 9)
	batch.set_body_transform(body, pose)
	check(batch.get_body_transform(body).origin.is_equal_approx(Vector3(9, 9, 9)), "set")
	batch.apply_impulse(body, Vector3(0, 0.001, 0), Vector3.ZERO)
	check(batch.get_body_linear_velocity(body).y > 0.05, "impulse")
	var still := batch.spawn(Transform3D.IDENTITY, Vector3.ZERO, Vector3.ZERO)
	batch.apply_force(still, Vector3(0.001, 0, 0), Vector3.ZERO)
	world.step(1.0 / 60.0)
	check(near(batch.get_body_linear_velocity(still).x, 0.001 / 0.00018 / 60.0, 0.02), "force along the leaf: F t/m")
	print("refused calls (2 expected)")
	check(batch.spawn(Transform3D(Basis.FLIP_X, Vector3.ZERO), Vector3.ZERO, Vector3.ZERO) == 0, "mirrored")
	check(batch.get_body_age(12345) == 0.0, "no such body")
	world.free()


func run_hash(simd: int, workers: int) -> int:
	var world := LangevinWorld.new()
	world.process_callback = LangevinWorld.PROCESS_CALLBACK_MANUAL
	world.seed = 42
	world.simd = simd
	world.workers = workers
	world.wind = Vector3(2, 0, 1)
	world.gust_speed = 1.0
	world.turbulence_speed = 0.5
	root.add_child(world)
	make_batch(world, 500, 700).emission_rate = 60.0
	for i in 60:
		world.step(1.0 / 60.0)
	var hash := world.get_state_hash()
	world.free()
	return hash


func test_determinism() -> void:
	var hash := run_hash(0, 0)
	check(hash != 0, "a hash")
	check(run_hash(0, 0) == hash, "the same again")
	check(run_hash(1, 0) == hash, "the same without SIMD")
	check(run_hash(0, 1) == hash, "the same with a worker")
	print("state %x after 1 s" % hash)


func test_snapshot() -> void:
	var world := make_world()
	world.wind = Vector3(1, 0, 0)
	world.turbulence_speed = 0.5
	var ground := floor_at(9.5)
	var batch := make_batch(world, 50)
	for i in 60:
		world.step(1.0 / 60.0)
	var saved := world.save_snapshot()
	var before := world.get_state_hash()
	for i in 60:
		world.step(1.0 / 60.0)
	var later := world.get_state_hash()
	check(world.restore_snapshot(saved) == OK and world.get_state_hash() == before, "restored")
	for i in 60:
		world.step(1.0 / 60.0)
	check(world.get_state_hash() == later, "and goes on as before, on the ground and in turbulence")
	ground.free()
	world.turbulence_speed = 0.0
	world.step(1.0 / 60.0)
	check(world.get_collider_count() == 0, "no collider")
	check(world.restore_snapshot(saved) == OK and world.get_collider_count() == 1, "that of the snapshot is back")
	world.step(1.0 / 60.0)
	check(world.get_collider_count() == 0, "and goes, as the scene has none")
	world.turbulence_speed = 0.1
	world.turbulence_speed = 0.0
	world.step(1.0 / 60.0)
	check(world.sample_wind(Vector3(1, 2, 3)).is_equal_approx(Vector3(1, 0, 0)), "turbulence of the snapshot ends")
	print("a refused snapshot (1 expected)")
	check(world.restore_snapshot(PackedByteArray([1, 2, 3])) != OK, "no snapshot")
	world.reset()
	world.step(1.0 / 60.0)
	check(batch.get_body_count() == 50 and near(world.get_time(), 1.0 / 60.0, 1e-6), "reset begins anew")
	world.free()


# test.sh replays the file with lr_replay.
func test_recording() -> void:
	var world := make_world()
	world.workers = 2
	var ground := floor_at(9.5)
	var area := Area3D.new()
	var collision := CollisionShape3D.new()
	collision.shape = SphereShape3D.new()
	collision.shape.radius = 20.0
	area.wind_force_magnitude = 2.0
	var source := Node3D.new()
	area.add_child(source)
	area.add_child(collision)
	root.add_child(area)
	area.wind_source_path = area.get_path_to(source)
	var batch := make_batch(world, 50, 60)
	for i in 30:
		world.step(1.0 / 60.0)
	var file := FileAccess.open("res://fall.lrrec", FileAccess.WRITE)
	check(world.start_recording(file) == OK, "a recording begins")
	print("refused recordings (2 expected)")
	check(world.start_recording(file) == ERR_INVALID_PARAMETER, "one at a time")
	check(world.start_recording(null) == ERR_INVALID_PARAMETER, "no file")
	batch.spawn(Transform3D(Basis(), Vector3(0, 11, 0)), Vector3.ZERO, Vector3.ZERO)
	for i in 60:
		world.step(1.0 / 60.0)
	check(world.stop_recording() == OK, "and ends")
	var length := file.get_length()
	check(length > 10000 and file.get_reference_count() == 1, "the file is whole, and given back")
	world.step(1.0 / 60.0)
	check(file.get_length() == length, "no more comes")
	world.free()
	ground.free()
	area.free()


func test_emitter_rules() -> void:
	var world := make_world()
	var batch := make_batch(world, 0, 1000)
	batch.emission_rate = 60.0
	batch.lifetime = 0.5
	batch.scale_min = 0.5
	batch.scale_max = 2.0
	for i in 120:
		world.step(1.0 / 60.0)
	check(absi(batch.get_body_count() - 30) <= 2, "rate times lifetime: %d" % batch.get_body_count())
	batch.emitting = false
	for i in 60:
		world.step(1.0 / 60.0)
	check(batch.get_body_count() == 0, "and none when it no longer emits")
	batch.lifetime = 0.0
	batch.position = Vector3(100, 0, 0)
	check(batch.emit(10) == OK, "emit")
	check(batch.get_positions()[0].x > 97.0, "the emitter goes along with the node")
	batch.bounds = AABB(Vector3(-10, -10, -10), Vector3(20, 20, 20))
	world.step(1.0 / 60.0)
	check(batch.get_body_count() == 0, "bodies outside of the bounds end")
	print("refused properties (2 expected)")
	batch.scale_min = -1.0
	check(batch.scale_min == 0.5, "a property out of range is refused")
	batch.asset = null
	batch.set("asset", BoxMesh.new())
	check(batch.asset == null, "an asset of another class is refused")
	world.free()


func test_wind() -> void:
	var world := make_world()
	world.wind = Vector3(3, 0, 0)
	world.step(1.0 / 60.0)
	check(world.sample_wind(Vector3.ZERO).is_equal_approx(Vector3(3, 0, 0)), "uniform wind")
	var source := Marker3D.new()
	source.rotation.y = PI / 2  # -z becomes -x
	var area := Area3D.new()
	var collision := CollisionShape3D.new()
	collision.shape = BoxShape3D.new()
	collision.shape.size = Vector3(20, 4, 4)
	area.add_child(collision)
	area.add_child(source)
	area.wind_source_path = area.get_path_to(source)
	area.wind_force_magnitude = 5.0
	area.wind_attenuation_factor = 1.0
	root.add_child(area)
	world.step(1.0 / 60.0)
	check(world.sample_wind(Vector3(-4, 0, 0)).is_equal_approx(Vector3(3 - 5.0 / 4.0, 0, 0)), "area, 4 m down the wind")
	check(world.sample_wind(Vector3(5, 1, 0)).is_equal_approx(Vector3(-2, 0, 0)), "area, behind its source")
	check(world.sample_wind(Vector3(-4, 3, 0)).is_equal_approx(Vector3(3, 0, 0)), "outside of it")
	area.position = Vector3(0, 3, 0)
	area.wind_attenuation_factor = 0.0
	collision.shape = SphereShape3D.new()
	world.step(1.0 / 60.0)
	check(world.sample_wind(Vector3(0, 3.4, 0)).is_equal_approx(Vector3(-2, 0, 0)), "a moved area, as a sphere")
	check(world.sample_wind(Vector3(0.4, 3.4, 0)).is_equal_approx(Vector3(3, 0, 0)), "outside of the sphere")
	world.wind_from_areas = false
	world.step(1.0 / 60.0)
	check(world.sample_wind(Vector3(0, 3, 0)).is_equal_approx(Vector3(3, 0, 0)), "areas switched off")
	world.wind_from_areas = true
	world.step(1.0 / 60.0)
	area.free()
	world.step(1.0 / 60.0)
	check(world.sample_wind(Vector3(0, 3, 0)).is_equal_approx(Vector3(3, 0, 0)), "a freed area")
	world.free()


func land(shape: Shape3D, height: float, at := Vector3.ZERO, turn := Vector3.ZERO) -> float:
	var world := make_world()
	var body := floor_at(height, shape)
	body.position += at
	body.rotation = turn
	var batch := make_batch(world, 0, 20)
	batch.emission_extents = Vector3(0.1, 0.1, 0.1)
	batch.position = Vector3(0, height + 1.5, 0)
	batch.emit(20)
	for i in 180:
		world.step(1.0 / 60.0)
	var sum := 0.0
	for p in batch.get_positions():
		sum += p.y / 20.0
	check(world.get_collider_count() == 1, "one collider")
	body.free()
	world.step(1.0 / 60.0)
	check(world.get_collider_count() == 0, "which goes with its node")
	world.free()
	return sum


func test_colliders() -> void:
	var box := BoxShape3D.new()
	box.size = Vector3(8, 2, 8)
	var cylinder := CylinderShape3D.new()
	cylinder.radius = 4.0
	cylinder.height = 2.0
	var sphere := SphereShape3D.new()
	sphere.radius = 50.0
	var hull := ConvexPolygonShape3D.new()
	hull.points = PackedVector3Array(
		[Vector3(-9, 1, -9), Vector3(9, 1, -9), Vector3(-9, 1, 9), Vector3(9, 1, 9), Vector3(0, -3, 0)]
	)
	var mesh := ConcavePolygonShape3D.new()
	mesh.set_faces(PackedVector3Array([Vector3(-30, 1, -30), Vector3(30, 1, -30), Vector3(0, 1, 40)]))
	var heights := HeightMapShape3D.new()
	heights.map_width = 9
	heights.map_depth = 9
	var data := PackedFloat32Array()
	data.resize(81)
	data.fill(1.0)
	heights.map_data = data
	var tilted := WorldBoundaryShape3D.new()
	tilted.plane = Plane(Vector3(0, 0, 1), 1.0)
	check(near(land(null, 5.0), 5.0, 0.03), "world boundary")
	check(near(land(tilted, 5.0, Vector3.ZERO, Vector3(-PI / 2, 0, 0)), 6.0, 0.03), "a boundary along z, turned up")
	check(near(land(box, 5.0), 6.0, 0.03), "box")
	check(near(land(cylinder, 5.0), 6.0, 0.03), "cylinder")
	check(near(land(sphere, 5.0, Vector3(0, -50, 0)), 5.0, 0.1), "sphere")
	check(near(land(hull, 5.0), 6.0, 0.03), "convex")
	check(near(land(mesh, 5.0), 6.0, 0.03), "concave")
	check(near(land(heights, 5.0), 6.0, 0.03), "height map")


func test_moving_colliders() -> void:
	var world := make_world()
	var body := floor_at(0.0)
	var batch := make_batch(world, 0, 20)
	batch.position.y = 0.3
	batch.emit(20)
	for i in 240:
		world.step(1.0 / 60.0)
	check(batch.get_awake_count() == 0, "they came to rest: %d awake" % batch.get_awake_count())
	var rows := batch.get_instance_buffer().slice(0, 240)
	check(rows == batch.get_transforms(), "what rests is drawn where it is")
	for i in 30:
		body.position.y += 0.02
		world.step(1.0 / 60.0)
	check(batch.get_positions()[0].y > 0.55, "they are lifted: %.3f" % batch.get_positions()[0].y)
	body.collision_layer = 2
	world.step(1.0 / 60.0)
	check(world.get_collider_count() == 0, "on another layer it is none")
	world.collision_mask = 3
	world.step(1.0 / 60.0)
	check(world.get_collider_count() == 1, "until that is in the mask")
	(body.get_child(0) as CollisionShape3D).disabled = true
	world.step(1.0 / 60.0)
	check(world.get_collider_count() == 0, "disabled shapes are none")
	body.free()
	world.free()


func test_signals() -> void:
	var world := make_world()
	var floor_body := floor_at(0.0)
	world.events = LangevinWorld.EVENTS_LANDED | LangevinWorld.EVENTS_TOUCHED | LangevinWorld.EVENTS_ENDED
	var batch := make_batch(world, 0, 20)
	batch.position.y = 0.5
	batch.emit(20)
	var seen := {"landed": 0, "touched": 0, "ended": 0, "fast": 0.0}
	batch.landed.connect(
		func(bodies: PackedInt64Array, positions: PackedVector3Array) -> void:
			seen.landed += bodies.size()
			check(positions.size() == bodies.size() and batch.has_body(bodies[0]), "landed bodies are there")
	)
	batch.touched.connect(
		func(bodies: PackedInt64Array, _positions: PackedVector3Array, speeds: PackedFloat32Array) -> void:
			seen.touched += bodies.size()
			seen.fast = maxf(seen.fast, speeds[0])
	)
	check(LangevinWorld.EVENTS_DIVERGED == 128 and batch.has_signal("diverged"), "there is a signal for divergence")
	batch.ended.connect(func(bodies: PackedInt64Array, _p: PackedVector3Array) -> void: seen.ended += bodies.size())
	for i in 240:
		world.step(1.0 / 60.0)
	check(seen.landed == 20, "all have landed: %d" % seen.landed)
	check(seen.touched >= 20 and seen.fast > 0.1, "all have touched the ground")
	batch.lifetime = 1.0
	for i in 20:
		world.step(1.0 / 60.0)
	check(seen.ended == 20 and batch.get_body_count() == 0, "all have ended: %d" % seen.ended)
	# A handler that frees a batch whose signals are still pending.
	batch.lifetime = 0.0
	var other := [make_batch(world, 5)]
	other[0].position.y = 0.5
	batch.emit(5)
	batch.touched.connect(
		func(_b: PackedInt64Array, _p: PackedVector3Array, _s: PackedFloat32Array) -> void:
			if other:
				other.pop_back().free()
	)
	for i in 120:
		world.step(1.0 / 60.0)
	check(other.is_empty() and world.get_body_count() == 5, "a handler may free another batch")
	world.free()
	floor_body.free()


func test_center_of_mass() -> void:
	# The ballast is off the middle, so the body's origin differs from the mesh's.
	var world := make_world()
	var batch := make_batch(world, 0, 4)
	batch.asset = load("res://shifted.lrb")
	var center := batch.asset.get_center_of_mass()
	check(near(center.x, 0.5, 0.001), "a mesh beside its origin: %s" % center)
	var pose := Transform3D(Basis(Vector3.UP, 0.4), Vector3(1, 2, 3))
	batch.spawn(pose, Vector3.ZERO, Vector3.ZERO)
	world.gravity = Vector3.ZERO
	world.step(1e-6)
	var drawn := transform_of_row(batch.get_instance_buffer(), 0)
	check((drawn * center).distance_to(Vector3(1, 2, 3)) < 1e-4, "the mesh's centre of mass is drawn at the body")
	check((drawn.basis.x - pose.basis.x).length() < 1e-4, "with its orientation")
	batch.mesh_transform = Transform3D(Basis.from_scale(Vector3.ONE * 0.01), Vector3.ZERO)
	world.step(1e-6)
	drawn = transform_of_row(batch.get_instance_buffer(), 0)
	check((drawn * (center * 100.0)).distance_to(Vector3(1, 2, 3)) < 1e-4, "a mesh drawn in centimetres")
	world.free()


func test_freeing_order() -> void:
	var world := make_world()
	var batch := make_batch(world, 10)
	world.step(1.0 / 60.0)
	world.remove_child(batch)
	world.step(1.0 / 60.0)
	check(world.get_body_count() == 0, "a batch that leaves takes its bodies along")
	world.add_child(batch)
	world.step(1.0 / 60.0)
	check(world.get_body_count() == 10, "and begins anew when it is back")
	root.remove_child(world)
	check(batch.get_body_count() == 0, "a world out of the tree has nothing")
	root.add_child(world)
	world.step(1.0 / 60.0)
	check(world.get_body_count() == 10, "and begins anew")
	var other := make_world()
	batch.reparent(other)
	other.step(1.0 / 60.0)
	check(other.get_body_count() == 10 and world.get_body_count() == 0, "from one world to another")
	batch.free()
	other.step(1.0 / 60.0)
	check(other.get_body_count() == 0, "batch first")
	world.free()
	other.queue_free()
	await process_frame
	check(not is_instance_valid(other), "queue_free")
	print("a batch without a world (1 expected)")
	var lonely := LangevinBatch.new()
	root.add_child(lonely)
	check(lonely.get_body_count() == 0, "a batch without a world")
	lonely.free()
	var scene: PackedScene = load("res://storm.tscn")
	for i in 3:
		var node := scene.instantiate()
		root.add_child(node)
		await physics_frame
		await physics_frame
		node.queue_free()
		await process_frame
	check(true, "scenes come and go")


func test_scene_runs_by_itself() -> void:
	var node: Node = load("res://storm.tscn").instantiate()
	root.add_child(node)
	for i in 30:
		await physics_frame
	var world: LangevinWorld = node.get_node("World")
	var batch: LangevinBatch = node.get_node("World/Leaves")
	check(world.get_time() > 0.4 and batch.get_body_count() >= 100, "physics frames step it")
	check(batch.capacity == 500 and batch.mesh is Mesh and batch.asset.is_valid(), "properties from the scene file")
	paused = true
	var time := world.get_time()
	for i in 5:
		await process_frame
	check(world.get_time() == time, "a paused tree stands still")
	paused = false
	node.free()


func test_speed() -> void:
	var world := make_world()
	var batch := make_batch(world, 20000)
	batch.emission_extents = Vector3(20, 5, 20)
	for i in 30:
		world.step(1.0 / 60.0)
	var start := Time.get_ticks_usec()
	for i in 60:
		world.step(1.0 / 60.0)
	var took := (Time.get_ticks_usec() - start) / 60.0
	print("speed: 20000 leaves, %d substeps, %s: %.0f us a frame" % [world.substeps, world.get_simd_name(), took])
	check(batch.get_body_count() == 20000, "20000 bodies")
	world.free()
