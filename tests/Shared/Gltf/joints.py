# Imports a GLB file into Blender and prints the joints of each armature as JSON, in the axes and metres of the file.
# blender -b --factory-startup --python-exit-code 1 --python joints.py -- FILE RATE TIMES
import json
import sys

import bpy

# The importer needs it. Debian only recommends it.
try:
    import numpy
except ImportError:
    print("LACKS NumPy")
    sys.exit(0)

# Debian 12 has an importer that needs this name, and a NumPy that has removed it.
if "bool" not in vars(numpy):
    numpy.bool = bool

path, rate, times = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)

# The importer turns seconds into frames.
scene = bpy.context.scene
scene.render.fps = int(rate)
bpy.ops.import_scene.gltf(filepath=path)


def to_file(point):
    return [point.x, point.z, -point.y]


result = []
for armature in (thing for thing in bpy.data.objects if thing.type == "ARMATURE"):
    # Blender plays one animation of a file. The others wait as tracks.
    for track in armature.animation_data.nla_tracks if armature.animation_data else []:
        if track.name == armature.name:
            armature.animation_data.action = track.strips[0].action
    poses = []
    for time in times.split(","):
        frame = float(time) * scene.render.fps
        scene.frame_set(int(frame), subframe=frame - int(frame))
        poses.append({bone.name: to_file(armature.matrix_world @ bone.head) for bone in armature.pose.bones})
    meshes = [thing for thing in bpy.data.objects if thing.type == "MESH" and thing.find_armature() == armature]
    result.append({"name": armature.name, "joints": poses, "vertices": sum(len(mesh.data.vertices) for mesh in meshes)})

print("JOINTS " + json.dumps(result))
