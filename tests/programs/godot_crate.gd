# Lets the pieces of an imported scene move, and prints where they are: godot3-server --path FOLDER -s godot_crate.gd
extends SceneTree

var bodies = []
var frames = 0

func statics(node, found):
	if node is StaticBody:
		found.append(node)
	for child in node.get_children():
		statics(child, found)
	return found

func shape_of(body):
	for child in body.get_children():
		if child is CollisionShape:
			return child
	return null

func _init():
	var scene = load("res://scene.glb").instance()
	root.add_child(scene)
	# Small things want small steps, and no air of 4 cm around them, as Godot 3 has it unless one says otherwise.
	Engine.iterations_per_second = 240
	for still in statics(scene, []):
		var shape = shape_of(still)
		shape.shape.margin = 0.001
		if shape == null or not shape.shape is ConvexPolygonShape:
			print("STILL ", still.get_parent().name, " ", shape.shape.get_class())
			continue
		var body = RigidBody.new()
		body.name = still.get_parent().name
		var moved = CollisionShape.new()
		moved.shape = shape.shape
		body.add_child(moved)
		var place = still.global_transform
		still.get_parent().remove_child(still)
		root.add_child(body)
		body.global_transform = place
		bodies.append(body)

func show(word):
	for body in bodies:
		var p = body.global_transform.origin
		print(word, " ", body.name, " ", p.x, " ", p.y, " ", p.z)

func _iteration(_delta):
	if frames == 0:
		show("BEGIN")
	frames += 1
	if frames == 480:
		show("END")
		quit()
	return false
