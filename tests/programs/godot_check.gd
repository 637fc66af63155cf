# Prints the nodes of an imported scene: godot3-server --path FOLDER -s godot_check.gd
extends SceneTree

func show(node, within):
	var path = within + "/" + node.name
	print("NODE ", node.get_class(), " ", path)
	if node is CollisionShape:
		print("SHAPE ", node.shape.get_class(), " ", node.shape.points.size())
	for child in node.get_children():
		show(child, path)

func _init():
	show(load("res://scene.glb").instance(), "")
	quit()
