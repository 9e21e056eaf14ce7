#nullable enable
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using NUnit.Framework;
using UnityEngine;

namespace NeuronMocap.Unity.Tests
{
    /// <summary>Unity accepts a built figure as a Humanoid, and the figure stands as the library says.</summary>
    public sealed class HumanoidFigureTests
    {
        private HumanoidFigure _figure = null!;

        /// <summary>Builds the figure.</summary>
        [SetUp]
        public void Build() => _figure = HumanoidFigure.Build(SkeletonBody.GetDefault());

        /// <summary>Removes it.</summary>
        [TearDown]
        public void Remove() => Object.DestroyImmediate(_figure.Root);

        /// <summary>Unity's own check of the avatar passes.</summary>
        [Test]
        public void Its_avatar_is_valid_and_human()
        {
            Assert.That(_figure.Avatar.isValid, Is.True);
            Assert.That(_figure.Avatar.isHuman, Is.True);
            Assert.That(_figure.Animator.isHuman, Is.True);
        }

        /// <summary>The figure has all of Unity's human bones except eyes and jaw.</summary>
        [Test]
        public void It_has_every_bone_that_a_performer_has()
        {
            int found = 0;
            for (HumanBodyBones bone = HumanBodyBones.Hips; bone < HumanBodyBones.LastBone; bone++)
                found += _figure.Animator.GetBoneTransform(bone) != null ? 1 : 0;

            Assert.That(found, Is.EqualTo(50));
            Assert.That(_figure.Animator.GetBoneTransform(HumanBodyBones.Jaw) == null, Is.True);
        }

        /// <summary>If the figure looks along z, left is at negative x, and the feet are down.</summary>
        [Test]
        public void It_stands_in_the_T_pose_and_looks_along_z()
        {
            Vector3 hips = GetPosition(HumanBodyBones.Hips);

            Assert.That(GetPosition(HumanBodyBones.LeftHand).x, Is.LessThan(hips.x - 0.4f));
            Assert.That(GetPosition(HumanBodyBones.RightHand).x, Is.GreaterThan(hips.x + 0.4f));
            Assert.That(GetPosition(HumanBodyBones.LeftFoot).y, Is.LessThan(hips.y - 0.5f));
        }

        /// <summary>The numbers and names of bones in the library match those of this Unity.</summary>
        [Test]
        public void Names_and_numbers_of_bones_are_Unity_s()
        {
            for (int bone = 0; bone < HumanoidBones.Count; bone++)
            {
                Assert.That(HumanoidBones.GetName((HumanoidBone)bone), Is.EqualTo(HumanTrait.BoneName[bone]));
                Assert.That(HumanoidBones.IsRequired((HumanoidBone)bone), Is.EqualTo(HumanTrait.RequiredBone(bone)));
                Assert.That(((HumanoidBone)bone).ToString(), Is.EqualTo(((HumanBodyBones)bone).ToString()));
            }
        }

        private Vector3 GetPosition(HumanBodyBones bone) => _figure.Animator.GetBoneTransform(bone)!.position;
    }
}
