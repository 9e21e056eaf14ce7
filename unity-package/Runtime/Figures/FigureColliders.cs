#nullable enable

using System;
using NeuronMocap.Retargeting;
using UnityEngine;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Adds capsules and kinematic bodies to the bones of a figure, so that it touches other objects. Set <see cref="FigureDriver.DriveTime"/> to
    /// Physics, so that the figure pushes them. Use it on the main thread.
    /// </summary>
    public static class FigureColliders
    {
        /// <summary>The end of the names of the objects that hold the capsules, below their bones.</summary>
        public const string NameSuffix = " Collider";

        /// <summary>
        /// Adds a capsule and a kinematic Rigidbody to each bone of hips, spine, head, arms and legs. Fingers have none. The capsules are as long as the
        /// bones, and as thick as fits the length of the legs. A bone with a Rigidbody is not changed.
        /// </summary>
        /// <param name="driver">The driver of the figure, which should be in the T-pose.</param>
        /// <returns>The number of bones that were changed.</returns>
        /// <exception cref="InvalidOperationException">The driver has no figure that it can move. The message says why.</exception>
        public static int Add(FigureDriver driver) => Add(driver, bone => bone.AddComponent<Rigidbody>(), _ => { });

        // addBody, onCreated: let the editor record what is added.
        internal static int Add(FigureDriver driver, Func<GameObject, Rigidbody> addBody, Action<GameObject> onCreated)
        {
            FigureRig rig = driver.FindRig(out string problem) ?? throw new InvalidOperationException(problem);
            float legs = rig.Target.LegLength > 0 ? rig.Target.LegLength : Mathf.Max(rig.Target.HipsHeight, 0.1f);
            int count = 0;
            foreach (ColliderShape shape in ColliderShape.All)
            {
                Transform? bone = Find(rig, shape.Bone);
                if (bone == null || bone.TryGetComponent(out Rigidbody _))
                    continue;

                AddCapsule(bone, EndOf(rig, shape, bone, legs), shape.Radius * legs * ScaleOf(rig), onCreated);
                Rigidbody body = addBody(bone.gameObject);
                body.isKinematic = true;
                body.useGravity = false;
                body.interpolation = RigidbodyInterpolation.Interpolate;
                body.collisionDetectionMode = CollisionDetectionMode.ContinuousSpeculative;
                count++;
            }

            driver.IgnoreOwnColliders();
            return count;
        }

        private static void AddCapsule(Transform bone, Vector3 end, float radius, Action<GameObject> onCreated)
        {
            var holder = new GameObject(bone.name + NameSuffix) { layer = bone.gameObject.layer };
            holder.transform.SetParent(bone, false);
            onCreated(holder);
            Vector3 local = bone.InverseTransformPoint(end);
            holder.transform.localPosition = local / 2;
            holder.transform.localRotation = Quaternion.FromToRotation(Vector3.up, local);

            // The sizes of a capsule are in the scale of its object.
            float scale = Mathf.Abs(holder.transform.lossyScale.y);
            CapsuleCollider capsule = holder.AddComponent<CapsuleCollider>();
            capsule.radius = scale > 0 ? radius / scale : radius;
            capsule.height = Mathf.Max(local.magnitude + capsule.radius, 2 * capsule.radius);
        }

        // The end of a bone in the world: the next bone that the figure has, or else an estimate.
        private static Vector3 EndOf(FigureRig rig, ColliderShape shape, Transform bone, float legs)
        {
            foreach (HumanoidBone next in shape.Next)
            {
                if (Find(rig, next) is { } end)
                    return end.position;
            }

            Transform root = rig.Nodes[0].parent!;
            Vector3 direction = shape.Before is { } before && Find(rig, before) is { } start
                ? bone.position - start.position
                : root.rotation * rig.Target.Facing.ToUnity() * Vector3.forward;
            return bone.position + (direction.normalized * (shape.Length * legs * ScaleOf(rig)));
        }

        // The rig is in the space of its root.
        private static float ScaleOf(FigureRig rig) => Mathf.Abs(rig.Nodes[0].parent!.lossyScale.y);

        private static Transform? Find(FigureRig rig, HumanoidBone bone)
        {
            int node = rig.Target.GetNode(bone);
            return node >= 0 && rig.Nodes[node] != null ? rig.Nodes[node] : null;
        }
    }
}
