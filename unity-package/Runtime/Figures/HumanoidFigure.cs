#nullable enable
using System;
using NeuronMocap.Figures;
using NeuronMocap.Skeleton;
using UnityEngine;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// A complete Humanoid character created at run time for an actor's body: 59 bones, a Humanoid <see cref="UnityEngine.Avatar"/>, an
    /// <see cref="Animator"/>, and one skinned mesh. Destroying <see cref="Root"/> destroys all of it. Use it on the main thread.
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

        /// <summary>Gets the figure's object, whose origin is on the ground between the feet.</summary>
        public GameObject Root { get; }

        /// <summary>Gets the body that the figure was built for.</summary>
        public SkeletonBody Body { get; }

        /// <summary>Gets the Humanoid avatar. It is destroyed with the figure.</summary>
        public Avatar Avatar { get; }

        /// <summary>Gets the Animator on <see cref="Root"/>. It has the avatar and no controller.</summary>
        public Animator Animator { get; }

        /// <summary>Gets the renderer of the figure, with two materials: one for the body, one for joints and visor.</summary>
        public SkinnedMeshRenderer Renderer { get; }

        /// <summary>Gets whether the figure was destroyed.</summary>
        public bool IsDestroyed => Root == null;

        /// <summary>Builds a figure in the T-pose, at the origin or at the place of its parent.</summary>
        /// <param name="body">The sizes.</param>
        /// <param name="look">Colours and material. Null: the defaults.</param>
        /// <param name="parent">The parent of the figure. Null: the scene itself.</param>
        /// <param name="name">Name of the figure's object. It is changed if a bone has the same name, because Unity needs unique names.</param>
        /// <returns>The figure.</returns>
        /// <exception cref="ArgumentNullException">The body is null.</exception>
        /// <exception cref="ArgumentException">Unity cannot create a Humanoid avatar for this body, for example because lengths are zero.</exception>
        public static HumanoidFigure Build(SkeletonBody body, FigureLook? look = null, Transform? parent = null, string name = "Figure")
        {
            if (body is null)
                throw new ArgumentNullException(nameof(body));

            bool isTaken = BoneHierarchy.TryFind(name.AsSpan(), body.Variant, out _);
            var root = new GameObject(isTaken ? name + " (figure)" : name);
            try
            {
                HumanoidFigure figure = Build(root, body, look ?? new FigureLook());

                // Not earlier, because AvatarBuilder requires a root without a parent.
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

        /// <summary>Gets the transform of a bone.</summary>
        /// <param name="bone">The bone.</param>
        /// <returns>Its transform.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
        public Transform GetBone(Bone bone)
        {
            if ((uint)bone >= (uint)_bones.Length)
                throw new ArgumentOutOfRangeException(nameof(bone), bone, "The bone must be one of the 59 bones, 0 to 58.");

            return _bones[(int)bone];
        }

        /// <summary>Destroys the figure and everything created for it. Further calls do nothing.</summary>
        public void Dispose() => Disposal.Destroy(Root);

        private static HumanoidFigure Build(GameObject root, SkeletonBody body, FigureLook look)
        {
            var owned = root.AddComponent<OwnedObjects>();
            Transform[] bones = FigureSkeleton.Create(root.transform, body);
            Avatar avatar = owned.Keep(AvatarBuilder.BuildHumanAvatar(root, FigureSkeleton.Describe(root.transform, bones, body.Variant)));
            avatar.name = root.name;
            if (!avatar.isValid || !avatar.isHuman)
                throw new ArgumentException("Unity cannot create a Humanoid avatar for this body: its lengths are zero, or not those of a human.", nameof(body));

            var animator = root.AddComponent<Animator>();
            animator.applyRootMotion = false;
            animator.avatar = avatar;
            return new HumanoidFigure(root, bones, body, avatar, animator, AddRenderer(root, bones, body, look, owned));
        }

        private static SkinnedMeshRenderer AddRenderer(GameObject root, Transform[] bones, SkeletonBody body, FigureLook look, OwnedObjects owned)
        {
            var surface = new GameObject("Surface");
            surface.transform.SetParent(root.transform, false);
            var renderer = surface.AddComponent<SkinnedMeshRenderer>();
            renderer.sharedMesh = owned.Keep(FigureMesh.Create(FigureSurface.Create(body)));
            renderer.bones = bones;
            renderer.rootBone = bones[(int)Bone.Hips];
            renderer.sharedMaterials = new[]
            {
                owned.Keep(FigureMaterials.Create(look.Material, look.BodyColor, "Figure body")),
                owned.Keep(FigureMaterials.Create(look.Material, look.AccentColor, "Figure joints")),
            };

            // Bounds around the hips that fit any pose. The mesh's own bounds fit only the T-pose.
            renderer.localBounds = new Bounds(Vector3.zero, 3 * renderer.sharedMesh.bounds.size.y * Vector3.one);
            return renderer;
        }
    }
}
