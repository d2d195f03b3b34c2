# Ten leaves fall for two seconds: godot --headless --path PROJECT --script res://sample.gd
# SPDX-License-Identifier: MIT
extends SceneTree


func _initialize() -> void:
	await process_frame  # before that, nodes are not in the tree
	var world := LangevinWorld.new()
	world.seed = 1
	world.process_callback = LangevinWorld.PROCESS_CALLBACK_MANUAL  # this script calls step() itself
	root.add_child(world)

	var leaves := LangevinBatch.new()
	leaves.asset = load("res://leaf.lrb")
	leaves.mesh = QuadMesh.new()
	leaves.capacity = 10
	leaves.emission_rate = 0.0
	world.add_child(leaves)
	var ids: Array[int] = []
	for i in 10:
		var pose := Transform3D(Basis(Vector3.RIGHT, -PI / 2 + 0.15 * i), Vector3(0.5 * i, 10, 0))
		ids.append(leaves.spawn(pose, Vector3.ZERO, Vector3.ZERO))

	for frame in 120:
		world.step(1.0 / 60.0)
	for i in 10:
		var fallen := 10.0 - leaves.get_body_transform(ids[i]).origin.y
		print("leaf %d: fell %.3f m, falls at %.3f m/s" % [i, fallen, -leaves.get_body_linear_velocity(ids[i]).y])
	print("state %x" % world.get_state_hash())
	world.free()
	quit(0)
