#nullable enable

using System;
using NeuronMocap.Retargeting;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Moves a figure as a performer of a <see cref="MocapSource"/> moves: what drivers of all kinds of figures have in common. The figure's rest pose is
    /// taken once, from its avatar or its skin, and not from the pose in which it happens to be. Main thread.
    /// </summary>
    public abstract partial class FigureDriver : MonoBehaviour
    {
        [Tooltip("Where the motion comes from. Empty: a source on this object or above it, else the first one in the scene.")]
        [SerializeField]
        private MocapSource? _source;

        [Tooltip("Find the performer by its number or by its name on the server.")]
        [SerializeField]
        private PerformerChoice _performerChoice;

        [Tooltip("Number of the performer on the server, from 0.")]
        [Min(0)]
        [SerializeField]
        private int _performerIndex;

        [Tooltip("Name of the performer on the server, in any case.")]
        [SerializeField]
        private string _performerName = string.Empty;

        [Tooltip("Late Update: after the Animator, so that the motion wins. Update: before it.")]
        [SerializeField]
        private DriveTime _driveTime;

        [Header("Body")]
        [Tooltip("Full: the figure follows the performer. Horizontal: it keeps its height. In Place: it does not move.")]
        [SerializeField]
        private RootMotion _rootMotion;

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

        [Header("Weights")]
        [Tooltip("How much of the motion the figure follows. The rest comes from its rest pose or its Animator.")]
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

        /// <summary>Where the motion comes from; null for a source on this object or above it, else the first of <see cref="MocapSource.All"/>.</summary>
        public MocapSource? Source
        {
            get => _source;
            set => _source = value;
        }

        /// <summary>Whether <see cref="PerformerIndex"/> or <see cref="PerformerName"/> counts. The index unless set.</summary>
        public PerformerChoice PerformerChoice
        {
            get => _performerChoice;
            set => _performerChoice = value;
        }

        /// <summary>Number of the performer on the server, from 0.</summary>
        public int PerformerIndex
        {
            get => _performerIndex;
            set => _performerIndex = value;
        }

        /// <summary>Name of the performer on the server, in any case.</summary>
        public string PerformerName
        {
            get => _performerName;
            set => _performerName = value ?? string.Empty;
        }

        /// <summary>When the figure is moved. LateUpdate unless set.</summary>
        public DriveTime DriveTime
        {
            get => _driveTime;
            set => _driveTime = value;
        }

        /// <summary>Which of the performer's ways the figure goes too.</summary>
        public RootMotion RootMotion
        {
            get => _rootMotion;
            set => _rootMotion = value;
        }

        /// <summary>Whether ways are measured by the length of the legs; else by <see cref="Scale"/>. True unless set.</summary>
        public bool AutomaticScale
        {
            get => _automaticScale;
            set => _automaticScale = value;
        }

        /// <summary>How far the figure goes for one metre of the performer's, where <see cref="AutomaticScale"/> is off. 0 or more; 1 unless set.</summary>
        public float Scale
        {
            get => _scale;
            set => _scale = value;
        }

        /// <summary>How much higher the hips are, in metres. 0 unless set.</summary>
        public float HeightOffset
        {
            get => _heightOffset;
            set => _heightOffset = value;
        }

        /// <summary>Whether feet are held where they touch the ground; not with <see cref="RootMotion.InPlace"/>. False unless set.</summary>
        public bool FootPlanting
        {
            get => _footPlanting;
            set => _footPlanting = value;
        }

        /// <summary>Height of the ground in the figure's own space, in metres. 0 unless set.</summary>
        public float GroundHeight
        {
            get => _groundHeight;
            set => _groundHeight = value;
        }

        /// <summary>How long a foot takes to be held and to be let go, in seconds. 0.15 unless set.</summary>
        public float FootBlendTime
        {
            get => _footBlendTime;
            set => _footBlendTime = value;
        }

        /// <summary>How a foot is turned while it stands. As the performer's unless set.</summary>
        public FootRotation FootRotation
        {
            get => _footRotation;
            set => _footRotation = value;
        }

        /// <summary>How much of the motion the figure takes over, 0 to 1; the rest is its rest pose, or what an Animator plays. 1 unless set.</summary>
        public float Weight
        {
            get => _weight;
            set => _weight = value;
        }

        /// <summary>How much each part of the body takes over. All of it unless set.</summary>
        public PartWeights PartWeights => _partWeights;

        /// <summary>What the figure does when its performer sends nothing. It holds its pose unless set.</summary>
        public IdleBehaviour WhenIdle
        {
            get => _whenIdle;
            set => _whenIdle = value;
        }

        /// <summary>How long the blend to rest takes, and the way back, in seconds, 0 to 10. 1 unless set.</summary>
        public float IdleBlendTime
        {
            get => _idleBlendTime;
            set => _idleBlendTime = value;
        }

        /// <summary>The performer whose motion this is; null while there is none.</summary>
        public Performer? Performer { get; private set; }

        /// <summary>The source in use: <see cref="Source"/> or the one that was found; null while there is none.</summary>
        public MocapSource? ActiveSource { get; private set; }

        /// <summary>Whether the figure was moved by a live performer in this frame.</summary>
        public bool IsDriving { get; private set; }

        /// <summary>Why the figure does not move, with the setting to change; empty when there is nothing wrong.</summary>
        public string Problem { get; private set; } = string.Empty;

        /// <summary>What is worth knowing about the figure's rest pose, such as that it had to be guessed; empty when there is nothing.</summary>
        public string RestPoseNote => Rig?.Note ?? string.Empty;

        /// <summary>The figure's transforms as the retargeter sees them; null while there is no figure.</summary>
        public TargetRig? TargetRig => Rig?.Target;

        /// <summary>Takes the figure's rest pose anew, after its avatar or its transforms were replaced.</summary>
        public void Rebind()
        {
            RestoreRest();
            _rig = null;
            _rigProblem = null;
        }
    }
}
