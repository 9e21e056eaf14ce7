#nullable enable
using System;
using NeuronMocap.Skeleton;
using UnityEngine;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// A complete Humanoid character made at run time for an actor's body: 59 bones, a human <see cref="UnityEngine.Avatar"/>, an <see cref="Animator"/>, and
    /// one skinned mesh. Everything ends with its <see cref="Root"/>. Main thread.
    /// </summary>
    public sealed class HumanoidFigure : IDisposable
    {
        private readonly Transform[] _bones;

        private HumanoidFigure(GameObject root, Transform[] bones, SkeletonBody body, Avatar avatar, Animator animator, SkinnedMeshRenderer renderer)
        {
            Root = root;
            _bones = bones;
            Body = body;
            Avatar = avatar;
            Animator = animator;
            Renderer = renderer;
        }

        /// <summary>The figure's object, whose origin is on the ground between the feet.</summary>
        public GameObject Root { get; }

        /// <summary>The body that it was built for.</summary>
        public SkeletonBody Body { get; }

        /// <summary>The human avatar. Destroyed with the figure.</summary>
        public Avatar Avatar { get; }

        /// <summary>On <see cref="Root"/>; has the avatar and no controller.</summary>
        public Animator Animator { get; }

        /// <summary>Draws the figure, in two materials: body, and joints with visor.</summary>
        public SkinnedMeshRenderer Renderer { get; }

        /// <summary>Whether it was destroyed.</summary>
        public bool IsDestroyed => Root == null;

        /// <summary>Builds a figure, standing in the T-pose at the origin, or as a child in the place of its parent.</summary>
        /// <param name="body">The sizes.</param>
        /// <param name="look">Colours and material; null for the defaults.</param>
        /// <param name="parent">What the figure is to hang from; null for the scene itself.</param>
        /// <param name="name">Name of the figure's object. One that a bone has is changed, because Unity needs them to differ.</param>
        /// <returns>The figure.</returns>
        /// <exception cref="ArgumentNullException">There is no body.</exception>
        /// <exception cref="ArgumentException">Unity makes no human avatar of this body, because lengths of it are zero for example.</exception>
        public static HumanoidFigure Build(SkeletonBody body, FigureLook? look = null, Transform? parent = null, string name = "Figure")
        {
            if (body is null)
                throw new ArgumentNullException(nameof(body));

            bool isTaken = BoneHierarchy.TryFind(name.AsSpan(), body.Variant, out _);
            var root = new GameObject(isTaken ? name + " (figure)" : name);
            try
            {
                HumanoidFigure figure = Build(root, body, look ?? new FigureLook());

                // Not before: AvatarBuilder wants a root without parent.
                if (parent != null)
                    root.transform.SetParent(parent, false);

                return figure;
            }
            catch
            {
                Disposal.Destroy(root);
                throw;
            }
        }

        /// <summary>The transform of a bone.</summary>
        /// <param name="bone">A bone.</param>
        /// <returns>Its transform.</returns>
        /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
        public Transform GetBone(Bone bone)
        {
            if ((uint)bone >= (uint)_bones.Length)
                throw new ArgumentOutOfRangeException(nameof(bone), bone, "The bone must be one of the 59 bones, 0 to 58.");

            return _bones[(int)bone];
        }

        /// <summary>Destroys the figure and all that was made for it. Again: nothing.</summary>
        public void Dispose() => Disposal.Destroy(Root);

        private static HumanoidFigure Build(GameObject root, SkeletonBody body, FigureLook look)
        {
            var owned = root.AddComponent<OwnedObjects>();
            Transform[] bones = FigureSkeleton.Create(root.transform, body);
            Avatar avatar = owned.Keep(AvatarBuilder.BuildHumanAvatar(root, FigureSkeleton.Describe(root.transform, bones, body.Variant)));
            avatar.name = root.name;
            if (!avatar.isValid || !avatar.isHuman)
                throw new ArgumentException("Unity makes no human avatar of this body: lengths of it are zero, or not those of a human.", nameof(body));

            var animator = root.AddComponent<Animator>();
            animator.applyRootMotion = false;
            animator.avatar = avatar;
            return new HumanoidFigure(root, bones, body, avatar, animator, AddRenderer(root, bones, body, look, owned));
        }

        private static SkinnedMeshRenderer AddRenderer(GameObject root, Transform[] bones, SkeletonBody body, FigureLook look, OwnedObjects owned)
        {
            var joints = new Vector3[bones.Length];
            for (int i = 0; i < joints.Length; i++)
                joints[i] = bones[i].position;

            var surface = new GameObject("Surface");
            surface.transform.SetParent(root.transform, false);
            var renderer = surface.AddComponent<SkinnedMeshRenderer>();
            renderer.sharedMesh = owned.Keep(FigureMesh.Create(FigureShapes.Of(body), joints));
            renderer.bones = bones;
            renderer.rootBone = bones[(int)Bone.Hips];
            renderer.sharedMaterials = new[]
            {
                owned.Keep(FigureMaterials.Create(look.Material, look.BodyColor, "Figure body")),
                owned.Keep(FigureMaterials.Create(look.Material, look.AccentColor, "Figure joints")),
            };

            // Around the hips, however the limbs are stretched: the mesh's own bounds know the T-pose only.
            renderer.localBounds = new Bounds(Vector3.zero, 3 * renderer.sharedMesh.bounds.size.y * Vector3.one);
            return renderer;
        }
    }
}
