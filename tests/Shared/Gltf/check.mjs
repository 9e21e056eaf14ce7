// Validates GLB files and loads them with three.js. Prints, for each file, the messages of the validator and the joints of each figure.
// node check.mjs FOLDER-WITH-NODE_MODULES TIMES FILE...
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder, times, ...files] = process.argv.slice(2);
const importFrom = path => import(pathToFileURL(resolve(folder, 'node_modules', path)).href);
const validator = createRequire(pathToFileURL(resolve(folder, 'package.json')))('gltf-validator');
const three = await importFrom('three/build/three.module.js');
const { GLTFLoader } = await importFrom('three/examples/jsm/loaders/GLTFLoader.js');

const results = [];
for (const file of files) {
  const bytes = readFileSync(file);
  const report = await validator.validateBytes(new Uint8Array(bytes), { maxIssues: 100 });
  const gltf = await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
  results.push({ issues: report.issues.messages.map(message => `${message.severity} ${message.code} ${message.pointer ?? ''}: ${message.message}`), figures: findFigures(gltf) });
}

console.log(JSON.stringify(results));

// The joints of each skin at each time, with all animations playing, and a vertex of the head's bone relative to the head.
function findFigures(gltf) {
  const mixer = new three.AnimationMixer(gltf.scene);
  for (const clip of gltf.animations) {
    const action = mixer.clipAction(clip);
    action.setLoop(three.LoopOnce);
    action.clampWhenFinished = true;
    action.play();
  }

  const skeletons = new Map();
  gltf.scene.traverse(node => node.isSkinnedMesh && skeletons.set(node.skeleton.bones[0], node));
  return [...skeletons.values()].map(mesh => ({
    names: mesh.skeleton.bones.map(bone => bone.userData.name ?? bone.name),
    clips: gltf.animations.map(clip => clip.name),
    joints: times.split(',').map(time => {
      mixer.setTime(Number(time));
      gltf.scene.updateMatrixWorld(true);
      return mesh.skeleton.bones.map(bone => bone.getWorldPosition(new three.Vector3()).toArray());
    }),
    size: skinnedSize(mesh),
  }));
}

// Width, height and depth of the surface as it is drawn.
function skinnedSize(mesh) {
  const box = new three.Box3();
  const vertex = new three.Vector3();
  for (let i = 0; i < mesh.geometry.attributes.position.count; i++)
    box.expandByPoint(mesh.getVertexPosition(i, vertex).applyMatrix4(mesh.matrixWorld));
  return box.getSize(vertex).toArray();
}
