import { type VRM, VRMLoaderPlugin, VRMUtils } from "@pixiv/three-vrm";
import { LoadingManager, Mesh, type Object3D, SkinnedMesh } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { drawEverywhere } from "../scene/bounds";
import { type CharacterFiles, findObstacle, readJson } from "./files";

const LargestFile = 1024 * 1024 * 1024;

/** A character as its file describes it. */
export interface LoadedCharacter {
  readonly name: string;
  readonly root: Object3D;
  /** Null for a glTF file without VRM's humanoid. */
  readonly vrm: VRM | null;
}

/** Reads a character. Throws an Error with a sentence if that is not possible. */
export async function loadCharacter(files: CharacterFiles<File>): Promise<LoadedCharacter> {
  const { main, parts } = files;
  if (main.size > LargestFile)
    throw new Error(`${main.name} is larger than 1 GB.`);

  const bytes = await main.arrayBuffer();
  const obstacle = findObstacle(main.name, readJson(main.name, bytes), parts);
  if (obstacle !== null)
    throw new Error(obstacle);

  // Buffers and pictures of a .gltf come from the files that were dropped with it, and never from the network.
  const opened: string[] = [];
  const manager = new LoadingManager();
  manager.setURLModifier(address => {
    if (/^(data|blob):/i.test(address))
      return address;

    const part = parts.find(address);
    if (!part)
      return "data:,";
    opened.push(URL.createObjectURL(part));
    return opened[opened.length - 1];
  });
  const loader = new GLTFLoader(manager);
  loader.register(parser => new VRMLoaderPlugin(parser));
  try {
    const gltf = await loader.parseAsync(bytes, "").catch((error: unknown) => {
      throw new Error(explain(main.name, error as Error), { cause: error });
    });
    return prepare(main.name, gltf.scene, (gltf.userData["vrm"] as VRM | undefined) ?? null);
  } finally {
    opened.forEach(URL.revokeObjectURL);
  }
}

function prepare(name: string, root: Object3D, vrm: VRM | null): LoadedCharacter {
  if (vrm)
    VRMUtils.rotateVRM0(vrm);
  root.traverse(object => {
    if (!(object instanceof Mesh))
      return;

    if (object instanceof SkinnedMesh && !isBound(object))
      throw new Error(`${name} is damaged: a part of it follows a joint that its skin does not have.`);

    object.castShadow = true;
    object.receiveShadow = true;
    drawEverywhere(object);
  });
  return { name, root, vrm };
}

// three.js would fail at every picture. It skips joints without weight, which may have any number.
function isBound({ geometry, skeleton }: SkinnedMesh): boolean {
  const joints = geometry.getAttribute("skinIndex");
  const weights = geometry.getAttribute("skinWeight");
  for (let i = 0; i < (joints?.count ?? 0); i++) {
    for (let slot = 0; slot < joints.itemSize; slot++) {
      if (joints.getComponent(i, slot) >= skeleton.bones.length && weights?.getComponent(i, slot) !== 0)
        return false;
    }
  }

  return true;
}

// Other messages of the loader are those of the script engine, which say nothing to a person.
function explain(name: string, error: Error): string {
  const missing = /humanoid bones are required but not exist: (.*)$/.exec(error.message);
  if (missing)
    return `${name} lacks these bones: ${inWords(missing[1])}.`;

  console.warn(error);
  return /alloc|memory/i.test(error.message)
    ? `${name} is too large for this browser.`
    : `${name} is damaged, and cannot be shown. Export it again.`;
}

// leftUpperArm becomes left upper arm.
function inWords(bones: string): string {
  return bones.replace(/[A-Z]/g, letter => ` ${letter.toLowerCase()}`);
}
