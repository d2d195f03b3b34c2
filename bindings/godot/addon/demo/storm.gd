# Two kinds of leaves in a gusty wind. A ball rolls through the leaves on the ground, and an Area3D blows them away.
# SPDX-License-Identifier: MIT
extends Node3D

@onready var world: LangevinWorld = $World
@onready var ball: AnimatableBody3D = $Ball
@onready var text: Label = $Text

var time := 0.0
var landed := 0


func _ready() -> void:
	world.events = LangevinWorld.EVENTS_LANDED
	for batch: LangevinBatch in [$World/Leaves, $World/MapleLeaves]:
		batch.landed.connect(func(bodies: PackedInt64Array, _at: PackedVector3Array) -> void: landed += bodies.size())


func _physics_process(delta: float) -> void:
	time += delta
	ball.position.x = -1.0 + sin(0.5 * time)
	ball.position.z = 0.5 + 0.5 * cos(0.5 * time)


func _process(_delta: float) -> void:
	text.text = (
		"%d leaves, %d moving, %d landings\nspace: stop and go   up, down: wind %.1f m/s"
		% [world.get_body_count(), world.get_awake_count(), landed, world.wind.x]
	)


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed("ui_accept"):
		world.process_mode = PROCESS_MODE_DISABLED if world.can_process() else PROCESS_MODE_INHERIT
	elif event.is_action_pressed("ui_up"):
		world.wind.x += 0.5
	elif event.is_action_pressed("ui_down"):
		world.wind.x -= 0.5
