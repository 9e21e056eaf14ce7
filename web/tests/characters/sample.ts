import { Euler, Matrix4, Quaternion, Vector3 } from "three";

/** A humanoid made of boxes, to test with. Heights and widths of the joints in metres; the left side is at +X. */
const Joints: readonly (readonly [name: string, parent: string, x: number, y: number, z: number])[] = [
  ["hips", "", 0, 0.95, 0],
  ["spine", "hips", 0, 1.05, 0],
  ["chest", "spine", 0, 1.18, 0],
  ["upperChest", "chest", 0, 1.3, 0],
  ["neck", "upperChest", 0, 1.45, 0],
  ["head", "neck", 0, 1.53, 0.01],
  ...(["left", "right"] as const).flatMap(side => {
    const s = side === "left" ? 1 : -1;
    return [
      [`${side}UpperLeg`, "hips", 0.09 * s, 0.9, 0],
      [`${side}LowerLeg`, `${side}UpperLeg`, 0.09 * s, 0.49, 0.005],
      [`${side}Foot`, `${side}LowerLeg`, 0.09 * s, 0.08, 0],
      [`${side}Toes`, `${side}Foot`, 0.09 * s, 0.02, 0.13],
      [`${side}Shoulder`, "upperChest", 0.04 * s, 1.4, 0],
      [`${side}UpperArm`, `${side}Shoulder`, 0.16 * s, 1.4, 0],
      [`${side}LowerArm`, `${side}UpperArm`, 0.42 * s, 1.4, 0],
      [`${side}Hand`, `${side}LowerArm`, 0.66 * s, 1.4, 0],
      [`${side}IndexProximal`, `${side}Hand`, 0.75 * s, 1.4, 0.02],
      [`${side}LittleProximal`, `${side}Hand`, 0.74 * s, 1.4, -0.04],
    ] as const;
  }),
];

/** Joints of a tail that swings, below the head. */
const Tail = 3;

export interface SampleOptions {
  /** "1" and "0" for VRM; null for plain glTF. */
  readonly vrm: "1" | "0" | null;
  /** The name of each joint's node. */
  readonly nameOf?: (joint: string) => string;
  /** Turns the nodes at rest, as programs for modelling do. */
  readonly twisted?: boolean;
  /** Degrees by which the arms are lowered when the skin is bound. */
  readonly lowered?: number;
  /** Degrees by which the nodes' arms differ from the bound skin, as in a file that was saved within an animation. */
  readonly posed?: number;
  /** The scale of the topmost node. The file's lengths are divided by it. */
  readonly scale?: number;
  /** A picture for the boxes. */
  readonly picture?: Uint8Array;
  /** Whether the file has Z up, and its topmost node turns that, as exports of FBX files do. */
  readonly zUp?: boolean;
  /** A second mesh with a skin of its own, and a morph target that raises the first. */
  readonly rich?: boolean;
  /** Joints without a node. */
  readonly without?: readonly string[];
}

export interface SampleFile {
  readonly json: Record<string, unknown>;
  readonly binary: ArrayBuffer;
}

interface Joint {
  readonly name: string;
  readonly parent: number;
  readonly place: Vector3;
  readonly turn: Quaternion;
}

/** Makes the parts of a file. */
export function makeSample(options: SampleOptions): SampleFile {
  const joints = makeJoints(options);
  const upright = makeJoints({ ...options, lowered: 0 });
  const bytes = new Bytes();
  const mesh = addMesh(joints, upright, options, bytes);
  const top = joints.length;
  const nodes = [
    ...joints.map((joint, i) => ({
      name: options.nameOf?.(joint.name) ?? joint.name,
      ...localOf(joints, i, options),
      children: joints.flatMap((other, index) => other.parent === i ? [index] : []),
    })).map(node => node.children.length > 0 ? node : { ...node, children: undefined }),
    { name: "Armature", scale: Array(3).fill(options.scale ?? 1), ...(options.zUp ? { rotation: Upright.toArray() } : {}), children: [0] },
    { name: "Body", mesh: 0, skin: 0 },
    ...(options.rich ? [{ name: "Clothes", mesh: 1, skin: 1 }] : []),
  ];
  const extensions = options.vrm === "1" ? vrm1(joints) : options.vrm === "0" ? vrm0(joints) : undefined;
  return {
    json: {
      asset: { version: "2.0", generator: "NeuronMocap tests" },
      scene: 0,
      scenes: [{ nodes: nodes.map((_, i) => i).slice(top) }],
      nodes,
      skins: [
        { joints: joints.map((_, i) => i), inverseBindMatrices: mesh.inverses, skeleton: 0 },
        ...(options.rich ? [{ joints: joints.map((_, i) => i), inverseBindMatrices: mesh.inverses }] : []),
      ],
      meshes: [
        { primitives: [options.rich ? { ...mesh.primitive, targets: [{ POSITION: mesh.primitive.attributes.NORMAL }] } : mesh.primitive] },
        ...(options.rich ? [{ primitives: [mesh.primitive] }] : []),
      ],
      materials: [{ pbrMetallicRoughness: { baseColorFactor: [0.75, 0.72, 0.68, 1], metallicFactor: 0, roughnessFactor: 0.8, ...(options.picture ? { baseColorTexture: { index: 0 } } : {}) } }],
      ...(options.picture ? { textures: [{ source: 0 }], images: [{ bufferView: bytes.addView(options.picture), mimeType: "image/png" }] } : {}),
      accessors: bytes.accessors,
      bufferViews: bytes.views,
      buffers: [{ byteLength: bytes.length }],
      ...(extensions ? { extensions, extensionsUsed: Object.keys(extensions) } : {}),
    },
    binary: bytes.join(),
  };
}

/** Joins the parts into a .glb or .vrm file. */
export function toGlb({ json, binary }: SampleFile): ArrayBuffer {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const textSize = Math.ceil(text.length / 4) * 4;
  const file = new Uint8Array(28 + textSize + binary.byteLength);
  const view = new DataView(file.buffer);
  [0x46546c67, 2, file.length, textSize, 0x4e4f534a].forEach((word, i) => view.setUint32(i * 4, word, true));
  file.fill(0x20, 20, 20 + textSize);
  file.set(text, 20);
  view.setUint32(20 + textSize, binary.byteLength, true);
  view.setUint32(24 + textSize, 0x004e4942, true);
  file.set(new Uint8Array(binary), 28 + textSize);
  return file.buffer;
}

/** The name that Mixamo gives a joint. */
export function mixamoName(joint: string): string {
  const side = /^(left|right)/.exec(joint)?.[1] ?? "";
  const part = joint.slice(side.length);
  const names: Record<string, string> = {
    hips: "Hips", spine: "Spine", chest: "Spine1", upperChest: "Spine2", neck: "Neck", head: "Head", UpperLeg: "UpLeg", LowerLeg: "Leg", Foot: "Foot", Toes: "ToeBase",
    Shoulder: "Shoulder", UpperArm: "Arm", LowerArm: "ForeArm", Hand: "Hand", IndexProximal: "HandIndex1", LittleProximal: "HandPinky1",
  };
  return `mixamorig:${side && side[0].toUpperCase() + side.slice(1)}${names[part] ?? part}`;
}

/** Turns Z up into Y up. */
const Upright = new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), -Math.PI / 2);

/** Brings a point of the figure to the axes and the unit of the file. */
function toFile(place: Vector3, { scale = 1, zUp }: SampleOptions): Vector3 {
  return place.clone().divideScalar(scale).applyQuaternion(zUp ? Upright.clone().invert() : new Quaternion());
}

function inverseOf({ place, turn }: Joint, options: SampleOptions): number[] {
  const rotation = options.zUp ? Upright.clone().invert().multiply(turn) : turn;
  return new Matrix4().compose(toFile(place, options), rotation, new Vector3(1, 1, 1)).invert().elements;
}

function makeJoints({ vrm, lowered = 0, twisted, without = [] }: SampleOptions): Joint[] {
  const rows = [...Joints.filter(([name]) => !without.includes(name))];
  for (let i = 0; i < Tail; i++)
    rows.push([`tail${i}`, i === 0 ? "head" : `tail${i - 1}`, 0, 1.62 - i * 0.12, -0.12]);

  // VRM 0.x faces backwards.
  const facing = vrm === "0" ? -1 : 1;
  return rows.map(([name, parent, x, y, z], i) => ({
    name,
    parent: rows.findIndex(([other]) => other === parent),
    place: lower(name, new Vector3(x, y, z), lowered).multiply(new Vector3(facing, 1, facing)),
    turn: twisted ? new Quaternion().setFromEuler(new Euler(0.3 * i, 1.1 + 0.7 * i, -0.4 * i)) : new Quaternion(),
  }));
}

// Turns a point of an arm about its joint.
function lower(name: string, place: Vector3, degrees: number): Vector3 {
  const joint = new Vector3(name.startsWith("left") ? 0.16 : -0.16, 1.4, 0);
  return turnWithArm(name, place.sub(joint), degrees).add(joint);
}

function turnWithArm(name: string, way: Vector3, degrees: number): Vector3 {
  const side = /^(left|right)(UpperArm|LowerArm|Hand|Index|Little)/.exec(name)?.[1];
  return side ? way.applyAxisAngle(new Vector3(0, 0, side === "left" ? -1 : 1), degrees * Math.PI / 180) : way;
}

function localOf(joints: readonly Joint[], index: number, options: SampleOptions): { translation: number[]; rotation: number[] } {
  const { name, parent, place, turn } = joints[index];
  const above = parent < 0 ? null : joints[parent];
  // The topmost node has turned the axes already.
  const back = above ? above.turn.clone().invert() : options.zUp ? Upright.clone().invert() : new Quaternion();
  const way = place.clone().sub(above?.place ?? new Vector3()).applyQuaternion(back).divideScalar(options.scale ?? 1);
  const rotation = back.multiply(turn);
  if (options.posed && name.endsWith("UpperArm"))
    rotation.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), options.posed * Math.PI / 180));
  return { translation: way.toArray(), rotation: rotation.toArray() };
}

// A box from each joint to its first child, bound to the joint. The boxes of lowered arms are lowered with them.
function addMesh(joints: readonly Joint[], upright: readonly Joint[], options: SampleOptions, bytes: Bytes) {
  const { lowered = 0 } = options;
  const [positions, normals, uvs, bones, weights, indices]: number[][] = [[], [], [], [], [], []];
  upright.forEach((joint, index) => {
    const child = upright.find(each => each.parent === index);
    const end = child?.place ?? joint.place.clone().add(joint.name === "head" ? new Vector3(0, 0.2, 0) : joint.place.clone().sub(upright[Math.max(0, joint.parent)].place).multiplyScalar(0.6));
    const size = /Hand|Index|Little|tail|Toes/.test(joint.name) ? 0.025 : 0.05;
    const [low, high] = [joint.place.clone().min(end).subScalar(size), joint.place.clone().max(end).addScalar(size)];
    low.y = Math.max(0, low.y);
    for (let axis = 0; axis < 3; axis++) {
      for (const sign of [-1, 1]) {
        const first = positions.length / 3;
        for (const [u, v] of [[0, 0], [1, 0], [1, 1], [0, 1]]) {
          const corner = [0, 0, 0];
          corner[axis] = sign;
          corner[(axis + 1) % 3] = (u * 2 - 1) * sign;
          corner[(axis + 2) % 3] = v * 2 - 1;
          const place = new Vector3(...[0, 1, 2].map(i => (corner[i] < 0 ? low : high).getComponent(i)));
          const normal = new Vector3().setComponent(axis, sign);
          positions.push(...toFile(lower(joint.name, place, lowered), options).toArray());
          normals.push(...turnWithArm(joint.name, normal, lowered).toArray());
          uvs.push(u, v);
          bones.push(index, 0, 0, 0);
          weights.push(1, 0, 0, 0);
        }

        indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
      }
    }
  });
  const inverses = joints.flatMap(joint => inverseOf(joint, options));
  return {
    inverses: bytes.add(new Float32Array(inverses), "MAT4"),
    primitive: {
      material: 0,
      attributes: {
        POSITION: bytes.add(new Float32Array(positions), "VEC3", true),
        NORMAL: bytes.add(new Float32Array(normals), "VEC3", options.rich),
        TEXCOORD_0: bytes.add(new Float32Array(uvs), "VEC2"),
        JOINTS_0: bytes.add(new Uint16Array(bones), "VEC4"),
        WEIGHTS_0: bytes.add(new Float32Array(weights), "VEC4"),
      },
      indices: bytes.add(new Uint16Array(indices), "SCALAR"),
    },
  };
}

function vrm1(joints: readonly Joint[]): Record<string, unknown> {
  const bones = joints.map((joint, node) => [joint.name, { node }] as const).filter(([name]) => !name.startsWith("tail"));
  return {
    VRMC_vrm: {
      specVersion: "1.0",
      meta: { name: "Boxes", version: "1", authors: ["NeuronMocap"], licenseUrl: "https://vrm.dev/licenses/1.0/" },
      humanoid: { humanBones: Object.fromEntries(bones) },
    },
    VRMC_springBone: {
      specVersion: "1.0",
      springs: [{ name: "Tail", joints: [0, 1, 2].map(i => ({ node: joints.findIndex(joint => joint.name === `tail${i}`), stiffness: 0.6, gravityPower: 0.3, dragForce: 0.3, hitRadius: 0.02 })) }],
    },
  };
}

function vrm0(joints: readonly Joint[]): Record<string, unknown> {
  const humanBones = joints.map((joint, node) => ({ bone: joint.name, node, useDefaultValues: true })).filter(({ bone }) => !bone.startsWith("tail"));
  return { VRM: { exporterVersion: "NeuronMocap tests", specVersion: "0.0", meta: { title: "Boxes", version: "1", author: "NeuronMocap" }, humanoid: { humanBones }, materialProperties: [] } };
}

class Bytes {
  readonly accessors: object[] = [];
  readonly views: object[] = [];
  length = 0;
  private readonly _parts: Uint8Array[] = [];

  add(values: Float32Array | Uint16Array, type: "SCALAR" | "VEC2" | "VEC3" | "VEC4" | "MAT4", bounds = false): number {
    const size = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 }[type];
    const columns = [0, 1, 2].map(axis => Array.from(values).filter((_, i) => i % 3 === axis));
    return this.accessors.push({
      bufferView: this.addView(new Uint8Array(values.buffer)),
      componentType: values instanceof Float32Array ? 5126 : 5123,
      count: values.length / size,
      type,
      ...(bounds ? { min: columns.map(each => Math.min(...each)), max: columns.map(each => Math.max(...each)) } : {}),
    }) - 1;
  }

  addView(bytes: Uint8Array): number {
    const view = this.views.push({ buffer: 0, byteOffset: this.length, byteLength: bytes.length }) - 1;
    this._parts.push(bytes, new Uint8Array((4 - bytes.length % 4) % 4));
    this.length += Math.ceil(bytes.length / 4) * 4;
    return view;
  }

  join(): ArrayBuffer {
    const all = new Uint8Array(this.length);
    let at = 0;
    for (const part of this._parts) {
      all.set(part, at);
      at += part.length;
    }

    return all.buffer;
  }
}
