#nullable enable
using System;
using System.Collections.Generic;
using NeuronMocap.Skeleton;
using UnityEngine;
#if UNITY_EDITOR
using UnityEditor;
#endif
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Draws a performer's skeleton as gizmos: bones, joints, foot contacts and trails. It is visible in the scene view, and in the game view if
    /// Gizmos is on. It shows what the source delivers. If the character looks different, the binding of the character is wrong.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Skeleton View")]
    [HelpURL(HelpPage.Components + "#skeleton-view")]
    [DefaultExecutionOrder(500)]
    public sealed class SkeletonView : MonoBehaviour
    {
        private const int PointsPerSecond = 60;
        private const float LongestTrail = 30;
        private const float ContactRadius = 0.06f;

        private static readonly string[][] Names =
        {
            GetNames(SkeletonVariant.Neck1),
            GetNames(SkeletonVariant.Spine3),
        };

        [SerializeField]
        [Tooltip("The driver whose performer is shown, at its character. Empty: see Source.")]
        private FigureDriver? _driver;

        [SerializeField]
        [Tooltip("The source whose performer is shown, at this object, if no driver is set.")]
        private MocapSource? _source;

        [SerializeField]
        [Min(0)]
        [Tooltip("Number of the source's performer.")]
        private int _performerIndex;

        [SerializeField]
        [Tooltip("Lines from joint to joint.")]
        private bool _showBones = true;

        [SerializeField]
        [Tooltip("Spheres at the joints.")]
        private bool _showJoints = true;

        [SerializeField]
        [Range(0.001f, 0.05f)]
        [Tooltip("Radius of a joint, in metres.")]
        private float _jointRadius = 0.012f;

        [SerializeField]
        [Tooltip("Discs under feet that touch the ground.")]
        private bool _showContacts = true;

        [SerializeField]
        [Tooltip("Names of the bones, in the editor.")]
        private bool _showNames;

        [SerializeField]
        [Range(0, LongestTrail)]
        [Tooltip("Length of trails, in seconds. 0 draws none.")]
        private float _trailSeconds;

        [SerializeField]
        [Tooltip("The joints that have trails.")]
        private Bone[] _trailBones = { Bone.LeftHand, Bone.RightHand, Bone.LeftFoot, Bone.RightFoot };

        [SerializeField]
        [Tooltip("Colour of the bones.")]
        private Color _boneColor = new Color(0.9f, 0.9f, 0.95f);

        [SerializeField]
        [Tooltip("Colour of the joints.")]
        private Color _jointColor = new Color(0.95f, 0.42f, 0.1f);

        [SerializeField]
        [Tooltip("Colour of the discs under feet that touch the ground.")]
        private Color _contactColor = new Color(0.2f, 0.9f, 0.35f);

        [SerializeField]
        [Tooltip("Colour of the trails.")]
        private Color _trailColor = new Color(0.3f, 0.7f, 1);

        private PositionTrail[] _trails = Array.Empty<PositionTrail>();
        private float _nextPoint;

        /// <summary>Gets or sets the driver whose performer is shown, at its character. Null: see <see cref="Source"/>.</summary>
        public FigureDriver? Driver
        {
            get => _driver;
            set => _driver = value;
        }

        /// <summary>Gets or sets the source whose performer is shown, at this object, if <see cref="Driver"/> is null.</summary>
        public MocapSource? Source
        {
            get => _source;
            set => _source = value;
        }

        /// <summary>Gets or sets the number of the source's performer.</summary>
        public int PerformerIndex
        {
            get => _performerIndex;
            set => _performerIndex = Mathf.Max(0, value);
        }

        /// <summary>Gets or sets whether bones are drawn.</summary>
        public bool ShowBones
        {
            get => _showBones;
            set => _showBones = value;
        }

        /// <summary>Gets or sets whether joints are drawn.</summary>
        public bool ShowJoints
        {
            get => _showJoints;
            set => _showJoints = value;
        }

        /// <summary>Gets or sets whether feet that touch the ground are marked.</summary>
        public bool ShowContacts
        {
            get => _showContacts;
            set => _showContacts = value;
        }

        /// <summary>Gets or sets whether the bones' names are drawn, in the editor.</summary>
        public bool ShowNames
        {
            get => _showNames;
            set => _showNames = value;
        }

        /// <summary>Gets or sets the length of the trails, 0 to 30 s. 0 draws none.</summary>
        public float TrailSeconds
        {
            get => _trailSeconds;
            set => _trailSeconds = Mathf.Clamp(value, 0, LongestTrail);
        }

        /// <summary>Gets or sets the joints that have trails. The list is copied.</summary>
        public IReadOnlyList<Bone> TrailBones
        {
            get => _trailBones;
            set => _trailBones = value is null ? Array.Empty<Bone>() : new List<Bone>(value).ToArray();
        }

        /// <summary>Gets the performer that is shown, or null.</summary>
        public Performer? Performer
        {
            get
            {
                if (_driver != null)
                    return _driver.Performer;

                return _source != null && _source.TryGetPerformer(_performerIndex, out Performer? performer) ? performer : null;
            }
        }

        // The transform at the stage's origin.
        private Transform Stage => _driver switch
        {
            HumanoidDriver humanoid when humanoid != null && humanoid.ActiveAnimator is { } animator => animator.transform,
            GenericRigDriver generic when generic != null && generic.Root != null => generic.Root,
            { } driver when driver != null => driver.transform,
            _ => transform,
        };

        // From the performer's stage to the scene. A root that travels is always at the hips.
        private Matrix4x4 FindPlace(Performer performer)
        {
            Matrix4x4 stage = Stage.localToWorldMatrix;
            if (_driver == null || _driver.RootMotionTarget == RootMotionTarget.Hips)
                return stage;

            Vector3 hips = performer.GetPosition(Bone.Hips);
            Quaternion facing = Heading.About(System.Numerics.Vector3.UnitY, performer.GetRotation(Bone.Hips).ToNumerics()).ToUnity();
            return stage * Matrix4x4.TRS(new Vector3(hips.x, 0, hips.z), facing, Vector3.one).inverse;
        }

        private void OnDisable() => _trails = Array.Empty<PositionTrail>();

        private void LateUpdate()
        {
            if (_trailSeconds <= 0 || !(Performer is { HasPose: true } performer))
                return;

            if (_trails.Length != _trailBones.Length)
                _trails = CreateTrails();

            float now = Time.unscaledTime;
            if (now < _nextPoint && _nextPoint - now < 1)
                return;

            _nextPoint = now + (1f / PointsPerSecond);
            for (int i = 0; i < _trails.Length; i++)
                _trails[i].Add(performer.GetPosition(_trailBones[i]), now, _trailSeconds);
        }

        private void OnDrawGizmos()
        {
            if (!isActiveAndEnabled || !(Performer is { HasPose: true } performer))
                return;

            Matrix4x4 before = Gizmos.matrix;
            Gizmos.matrix = FindPlace(performer);
            if (_showBones)
                DrawBones(performer);
            if (_showJoints)
                DrawJoints(performer);
            if (_showContacts)
                DrawContacts(performer);
            if (_trailSeconds > 0)
                DrawTrails();
            if (_showNames)
                DrawNames(performer);

            Gizmos.matrix = before;
        }

        private void DrawBones(Performer performer)
        {
            Gizmos.color = _boneColor;
            foreach (Bone bone in BoneHierarchy.Bones)
            {
                if (BoneHierarchy.GetParent(bone, performer.Variant) is { } parent)
                    Gizmos.DrawLine(performer.GetPosition(parent), performer.GetPosition(bone));
            }

            foreach (Bone bone in JointPositions.EndSiteBones)
                Gizmos.DrawLine(performer.GetPosition(bone), performer.GetEndPosition(bone));
        }

        private void DrawJoints(Performer performer)
        {
            Gizmos.color = _jointColor;
            foreach (Bone bone in BoneHierarchy.Bones)
                Gizmos.DrawSphere(performer.GetPosition(bone), IsOfHand(bone) ? _jointRadius / 2 : _jointRadius);
        }

        private void DrawContacts(Performer performer)
        {
            Gizmos.color = _contactColor;
            FootContacts contacts = performer.Contacts;
            if (contacts.Left)
                DrawContact(performer, Bone.LeftFoot);
            if (contacts.Right)
                DrawContact(performer, Bone.RightFoot);
        }

        // A flat disc below the middle of the foot, at the height of the foot's end, which is the sole.
        private static void DrawContact(Performer performer, Bone foot)
        {
            Vector3 toes = performer.GetEndPosition(foot);
            Vector3 place = (performer.GetPosition(foot) + toes) / 2;
            place.y = toes.y;
            Matrix4x4 stage = Gizmos.matrix;
            Gizmos.matrix = stage * Matrix4x4.TRS(place, Quaternion.identity, new Vector3(1, 0.05f, 1));
            Gizmos.DrawSphere(Vector3.zero, ContactRadius);
            Gizmos.matrix = stage;
        }

        private void DrawTrails()
        {
            foreach (PositionTrail trail in _trails)
                trail.Draw(_trailColor);
        }

        [System.Diagnostics.Conditional("UNITY_EDITOR")]
        private void DrawNames(Performer performer)
        {
#if UNITY_EDITOR
            Matrix4x4 before = Handles.matrix;
            Handles.matrix = FindPlace(performer);
            string[] names = Names[(int)performer.Variant];
            foreach (Bone bone in BoneHierarchy.Bones)
            {
                if (!IsOfHand(bone))
                    Handles.Label(performer.GetPosition(bone), names[(int)bone]);
            }

            Handles.matrix = before;
#endif
        }

        private PositionTrail[] CreateTrails()
        {
            var trails = new PositionTrail[_trailBones.Length];
            for (int i = 0; i < trails.Length; i++)
                trails[i] = new PositionTrail((int)(LongestTrail * PointsPerSecond));

            return trails;
        }

        private static bool IsOfHand(Bone bone) =>
            (bone > Bone.RightHand && bone < Bone.LeftShoulder) || bone > Bone.LeftHand;

        private static string[] GetNames(SkeletonVariant variant)
        {
            var names = new string[BoneHierarchy.BoneCount];
            foreach (Bone bone in BoneHierarchy.Bones)
                names[(int)bone] = BoneHierarchy.GetName(bone, variant);

            return names;
        }
    }
}
