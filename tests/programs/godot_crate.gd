# Lets the pieces of an imported scene move, and prints where they are: godot3-server --path FOLDER -s godot_crate.gd
extends SceneTree

# Godot 3's physics (Bullet) take what is within 2 cm for touching, so things of that size never rest. So all is ten times
# as large, falls ten times as fast, and is printed in its own size again.
const LARGER = 10.0
const MARGIN = 0.001 * LARGER  # no air of 4 cm around things, as Godot 3 has it unless one says otherwise
const RESISTANCE = 5.0  # to turning: nothing else resists rolling
const STEPS_A_SECOND = 240
const SECONDS = 2

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
			return child.shape
	return null

func larger(points):
	for i in range(points.size()):
		points[i] *= LARGER
	return points

func add(body, shape, place):
	var child = CollisionShape.new()
	shape.margin = MARGIN
	child.shape = shape
	body.add_child(child)
	root.add_child(body)
	body.global_transform = place

func _init():
	var scene = load("res://scene.glb").instance()
	root.add_child(scene)
	Engine.iterations_per_second = STEPS_A_SECOND
	PhysicsServer.area_set_param(root.world.space, PhysicsServer.AREA_PARAM_GRAVITY, 9.81 * LARGER)
	add(StaticBody.new(), PlaneShape.new(), Transform())
	for still in statics(scene, []):
		var found = shape_of(still)
		var place = still.global_transform
		var name = still.get_parent().name
		place.origin *= LARGER
		still.get_parent().remove_child(still)
		if not found is ConvexPolygonShape:
			print("STILL ", name, " ", found.get_class())
			var triangles = ConcavePolygonShape.new()
			triangles.set_faces(larger(found.get_faces()))
			add(StaticBody.new(), triangles, place)
			continue
		var hull = ConvexPolygonShape.new()
		hull.points = larger(found.points)
		var body = RigidBody.new()
		body.name = name
		body.angular_damp = RESISTANCE
		add(body, hull, place)
		bodies.append(body)

func show(word):
	for body in bodies:
		var p = body.global_transform.origin / LARGER
		print(word, " ", body.name, " ", p.x, " ", p.y, " ", p.z)

# Metres a second.
func fastest():
	var speed = 0
	for body in bodies:
		speed = max(speed, body.linear_velocity.length() / LARGER)
	return speed

func _iteration(_delta):
	if frames == 0:
		show("BEGIN")
	frames += 1
	if frames == STEPS_A_SECOND * SECONDS:
		show("END")
		print("FASTEST ", fastest())
		quit()
	return false
