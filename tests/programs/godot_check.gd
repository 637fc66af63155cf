# Prints the nodes of an imported scene, and colours of its like with an atlas: godot3-server --path FOLDER -s godot_check.gd
extends SceneTree

func show(node, within):
	var path = within + "/" + node.name
	print("NODE ", node.get_class(), " ", path)
	if node is CollisionShape:
		print("SHAPE ", node.shape.get_class(), " ", node.shape.points.size())
	for child in node.get_children():
		show(child, path)

# What the image of each mesh has at some of its vertices: place, micrometres, and colour, of 255.
func sample(node):
	if node is MeshInstance and node.mesh.get_surface_count() == 1:
		var arrays = node.mesh.surface_get_arrays(0)
		var image = node.mesh.surface_get_material(0).albedo_texture.get_data()
		image.lock()
		for i in range(0, arrays[Mesh.ARRAY_VERTEX].size(), 20):
			var p = (arrays[Mesh.ARRAY_VERTEX][i] * 1e6).round()
			var at = arrays[Mesh.ARRAY_TEX_UV][i] * image.get_size()
			var texel = image.get_pixel(min(at.x, image.get_width() - 1), min(at.y, image.get_height() - 1))
			print("TEXEL ", node.name, " ", p.x, " ", p.y, " ", p.z, " ", texel.r8, " ", texel.g8, " ", texel.b8)
	for child in node.get_children():
		sample(child)

func _init():
	show(load("res://scene.glb").instance(), "")
	if ResourceLoader.exists("res://atlas.glb"):
		sample(load("res://atlas.glb").instance())
	quit()
