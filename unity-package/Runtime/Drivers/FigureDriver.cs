#nullable enable

using System;
using NeuronMocap.Retargeting;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Base class of the drivers: moves a figure as a performer of a <see cref="MocapSource"/> moves. It captures the figure's rest pose once, from
    /// the avatar or the skin, independent of the current pose. Use it on the main thread.
    /// </summary>
    public abstract partial class FigureDriver : MonoBehaviour
    {
        [Tooltip("Where the motion comes from. Empty: a source on this object or above it, or else the first one in the scene.")]
        [SerializeField]
        private MocapSource? _source;

        [Tooltip("Find the performer by its number or by its name on the server.")]
        [SerializeField]
        private PerformerChoice _performerChoice;

        [Tooltip("Number of the performer on the server, from 0.")]
        [Min(0)]
        [SerializeField]
        private int _performerIndex;

        [Tooltip("Name of the performer on the server. Case is ignored.")]
        [SerializeField]
        private string _performerName = string.Empty;

        [Tooltip("Late Update: after the Animator, so that the motion wins. Update: before it. Physics: in physics steps, so that bodies in the way are pushed.")]
        [SerializeField]
        private DriveTime _driveTime;

        [Header("Body")]
        [Tooltip("Full: the figure follows the performer. Horizontal: it keeps its height. In Place: it only moves up and down.")]
        [SerializeField]
        private RootMotion _rootMotion;

        [Tooltip("Hips: the root transform stays in place. Root Transform: it moves and turns with the performer. Character Controller: moves the controller on "
            + "this object or a parent, with collisions and gravity.")]
        [SerializeField]
        private RootMotionTarget _rootMotionTarget;

        [Tooltip("Scale root motion by leg length to prevent foot sliding. Off: use Scale.")]
        [SerializeField]
        private bool _automaticScale = true;

        [Tooltip("Distance that the figure moves for one metre of the performer.")]
        [Range(0, 10)]
        [SerializeField]
        private float _scale = 1;

        [Tooltip("Raises the hips, in metres.")]
        [Range(-1, 1)]
        [SerializeField]
        private float _heightOffset;

        [Tooltip("Place every bone where the performer's bone is, at the figure's size. The figure takes over the performer's proportions. For streams with displacement.")]
        [SerializeField]
        private bool _displacement;

        [Header("Feet")]
        [Tooltip("Hold feet where they touch the ground, and keep them above it. No effect with root motion In Place.")]
        [SerializeField]
        private bool _footPlanting;

        [Tooltip("Height of the ground in the space of this object, in metres.")]
        [SerializeField]
        private float _groundHeight;

        [Tooltip("Seconds to blend into and out of foot planting.")]
        [Range(0, 1)]
        [SerializeField]
        private float _footBlendTime = 0.15f;

        [Tooltip("Keep: a planted foot rolls like the performer's. Flatten: its whole sole stays on the ground.")]
        [SerializeField]
        private FootRotation _footRotation;

        [Header("Smoothing")]
        [Tooltip("Remove noise from the motion, with a delay that the inspector shows. Off: the figure follows the motion as it is.")]
        [SerializeField]
        private bool _smoothing;

        [Tooltip("How strongly each body part is smoothed.")]
        [SerializeField]
        private PartSmoothing _partSmoothing = new PartSmoothing();

        [Header("Weights")]
        [Tooltip("How much of the motion the figure follows. The remainder comes from its rest pose or its Animator.")]
        [Range(0, 1)]
        [SerializeField]
        private float _weight = 1;

        [Tooltip("How much of the motion each body part follows. A part at 0 is not changed.")]
        [SerializeField]
        private PartWeights _partWeights = new PartWeights();

        [Header("When data stops")]
        [Tooltip("Keep the last pose, or blend to the rest pose (or to the Animator's pose).")]
        [SerializeField]
        private IdleBehaviour _whenIdle;

        [Tooltip("Seconds to blend to the idle pose, and back when data resumes.")]
        [Range(0, 10)]
        [SerializeField]
        private float _idleBlendTime = 1;

        /// <summary>
        /// Gets or sets the source of the motion. Null: a source on this object or above it, or else the first of <see cref="MocapSource.All"/>.
        /// </summary>
        public MocapSource? Source
        {
            get => _source;
            set => _source = value;
        }

        /// <summary>
        /// Gets or sets whether the performer is found by <see cref="PerformerIndex"/> or <see cref="PerformerName"/>. The default is the index.
        /// </summary>
        public PerformerChoice PerformerChoice
        {
            get => _performerChoice;
            set => _performerChoice = value;
        }

        /// <summary>Gets or sets the number of the performer on the server, from 0.</summary>
        public int PerformerIndex
        {
            get => _performerIndex;
            set => _performerIndex = value;
        }

        /// <summary>Gets or sets the name of the performer on the server. Case is ignored.</summary>
        public string PerformerName
        {
            get => _performerName;
            set => _performerName = value ?? string.Empty;
        }

        /// <summary>Gets or sets when the figure is moved. The default is LateUpdate.</summary>
        public DriveTime DriveTime
        {
            get => _driveTime;
            set => _driveTime = value;
        }

        /// <summary>Gets or sets which part of the performer's root motion the figure follows.</summary>
        public RootMotion RootMotion
        {
            get => _rootMotion;
            set => _rootMotion = value;
        }

        /// <summary>Gets or sets what the root motion moves: the hips, the root transform or a character controller. The default is the hips.</summary>
        public RootMotionTarget RootMotionTarget
        {
            get => _rootMotionTarget;
            set => _rootMotionTarget = value;
        }

        /// <summary>Gets or sets whether root motion is scaled by leg length. If false, <see cref="Scale"/> applies. The default is true.</summary>
        public bool AutomaticScale
        {
            get => _automaticScale;
            set => _automaticScale = value;
        }

        /// <summary>
        /// Gets or sets how far the figure moves for each metre of the performer if <see cref="AutomaticScale"/> is off, 0 or more. The default is 1.
        /// </summary>
        public float Scale
        {
            get => _scale;
            set => _scale = value;
        }

        /// <summary>Gets or sets an offset that raises the hips, in metres. The default is 0.</summary>
        public float HeightOffset
        {
            get => _heightOffset;
            set => _heightOffset = value;
        }

        /// <summary>
        /// Gets or sets whether every driven bone takes over the position of the performer's bone, relative to the hips and scaled by leg length. The
        /// figure takes over the performer's proportions. Use it with streams that have displacement; other streams have only the performer's known or
        /// default sizes. The default is false: the figure keeps its own bone lengths.
        /// </summary>
        public bool Displacement
        {
            get => _displacement;
            set => _displacement = value;
        }

        /// <summary>
        /// Gets or sets whether feet are held where they touch the ground. It has no effect with <see cref="RootMotion.InPlace"/>. The default is
        /// false.
        /// </summary>
        public bool FootPlanting
        {
            get => _footPlanting;
            set => _footPlanting = value;
        }

        /// <summary>Gets or sets the height of the ground in the figure's own space, in metres. The default is 0.</summary>
        public float GroundHeight
        {
            get => _groundHeight;
            set => _groundHeight = value;
        }

        /// <summary>Gets or sets how long a foot takes to blend into and out of foot planting, in seconds. The default is 0.15.</summary>
        public float FootBlendTime
        {
            get => _footBlendTime;
            set => _footBlendTime = value;
        }

        /// <summary>Gets or sets how a planted foot is turned. By default it keeps the performer's rotation.</summary>
        public FootRotation FootRotation
        {
            get => _footRotation;
            set => _footRotation = value;
        }

        /// <summary>
        /// Gets or sets how much of the motion the figure follows, 0 to 1. The remainder is the last pose of an Animator, or the rest pose. The default is
        /// 1.
        /// </summary>
        public float Weight
        {
            get => _weight;
            set => _weight = value;
        }

        /// <summary>Gets how much of the motion each part of the body follows. By default every part follows it fully.</summary>
        public PartWeights PartWeights => _partWeights;

        /// <summary>Gets or sets what the figure does when its performer sends nothing. By default it holds its pose.</summary>
        public IdleBehaviour WhenIdle
        {
            get => _whenIdle;
            set => _whenIdle = value;
        }

        /// <summary>Gets or sets how long the blend to the idle pose and back takes, in seconds, 0 to 10. The default is 1.</summary>
        public float IdleBlendTime
        {
            get => _idleBlendTime;
            set => _idleBlendTime = value;
        }

        /// <summary>Gets the performer that the figure follows, or null.</summary>
        public Performer? Performer { get; private set; }

        /// <summary>Gets the source in use: <see cref="Source"/>, or the source that was found. Null if there is none.</summary>
        public MocapSource? ActiveSource { get; private set; }

        /// <summary>Gets whether a live performer moved the figure in this frame, or in the latest physics step.</summary>
        public bool IsDriving { get; private set; }

        /// <summary>Gets the reason why the figure does not move, and the setting to change. Empty if there is no problem.</summary>
        public string Problem { get; private set; } = string.Empty;

        /// <summary>Gets a note about the figure's rest pose, such as that it is a guess. Empty if there is none.</summary>
        public string RestPoseNote => Rig?.Note ?? string.Empty;

        /// <summary>Gets the figure's transforms as the retargeter sees them, or null if there is no figure.</summary>
        public TargetRig? TargetRig => Rig?.Target;

        /// <summary>Captures the figure's rest pose again. Call it after you replace its avatar or its transforms.</summary>
        public void Rebind()
        {
            RestoreRest();
            RestoreScene();
            _rig = null;
            _rigProblem = null;
        }
    }
}
