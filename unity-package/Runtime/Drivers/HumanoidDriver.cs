#nullable enable

using System;
using System.Collections.Generic;
using NeuronMocap.Retargeting;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Moves a figure that has an Animator with a Humanoid avatar as a performer moves. The figure may have any proportions and any rest pose. Its bones
    /// turn away from the avatar's T-pose as the performer's bones do.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Humanoid Driver")]
    [HelpURL(HelpPage.Components + "#humanoid-driver")]
    public sealed class HumanoidDriver : FigureDriver
    {
        [Header("Humanoid")]
        [Tooltip("The figure. Empty: the Animator on this object, or the first one below it.")]
        [SerializeField]
        private Animator? _animator;

        [Tooltip("Weights of single bones, multiplied by those of their body parts.")]
        [SerializeField]
        private List<HumanoidBoneWeight> _boneWeights = new List<HumanoidBoneWeight>();

        [NonSerialized]
        private Animator? _bound;

        /// <summary>Gets or sets the figure. Null: the Animator on this object, or the first one below it.</summary>
        public Animator? Animator
        {
            get => _animator;
            set
            {
                if (ReferenceEquals(_animator, value))
                    return;

                Rebind();
                _animator = value;
            }
        }

        /// <summary>Gets the Animator in use: <see cref="Animator"/>, or the one that was found. Null while there is no figure.</summary>
        public Animator? ActiveAnimator => Rig != null && _bound != null ? _bound : null;

        /// <summary>Gets weights of single bones, multiplied by those of their body parts. Bones that are not listed have weight 1.</summary>
        public IList<HumanoidBoneWeight> BoneWeights => _boneWeights;

        private protected override bool IsBound => _bound != null && (_animator == null || _animator == _bound);

        private protected override FigureRig? CreateRig(out string problem)
        {
            Animator? animator = _animator != null ? _animator : GetComponentInChildren<Animator>(true);
            problem = FindFault(animator);
            if (problem.Length > 0)
                return null;

            Transform root = animator!.transform;
            var bones = new Transform?[HumanoidBones.Count];
            for (int bone = 0; bone < bones.Length; bone++)
                bones[bone] = animator.GetBoneTransform((HumanBodyBones)bone);

            if (bones[0] == null)
            {
                // An Animator finds its bones when its object first becomes active.
                problem = animator.gameObject.activeInHierarchy
                    ? "The figure's bones are not in the scene. In the model's import settings, tab Rig, switch Optimize Game Objects off."
                    : $"The figure {animator.name} is not active. It moves as soon as it is.";
                return null;
            }

            _bound = animator;
            RestPose rest = RestPose.OfAvatar(root, animator.avatar!);
            RigCapture capture = RigCapture.Take(root, bones, rest);
            int[] nodeByBone = Array.ConvertAll(bones, capture.IndexOf);
            try
            {
                return new FigureRig(TargetRig.CreateHumanoid(capture.Nodes, nodeByBone), capture.Transforms, rest.Note);
            }
            catch (ArgumentException exception)
            {
                problem = $"The avatar cannot be driven: {exception.Message}";
                return null;
            }
        }

        private protected override void CopyBoneWeights(BoneWeights weights)
        {
            for (int i = 0; i < _boneWeights.Count; i++)
            {
                HumanoidBoneWeight bone = _boneWeights[i];
                if ((uint)bone.Bone < HumanoidBones.Count)
                    weights[bone.Bone] = Mathf.Clamp01(bone.Weight);
            }
        }

        private static string FindFault(Animator? animator)
        {
            if (animator == null)
                return "No Animator found. Put this component on the figure, or assign the figure's Animator to Animator.";
            if (animator.avatar == null)
                return "The Animator has no avatar. In the model's import settings, tab Rig, set Animation Type to Humanoid, and assign the avatar to the Animator.";
            if (!animator.avatar.isValid)
                return $"The avatar {animator.avatar.name} is not valid. In the model's import settings, tab Rig, open Configure and map the bones in red.";
            if (!animator.avatar.isHuman)
                return $"The avatar {animator.avatar.name} is not Humanoid. In the model's import settings, tab Rig, set Animation Type to Humanoid, or use a Generic Rig Driver.";

            return string.Empty;
        }
    }
}
