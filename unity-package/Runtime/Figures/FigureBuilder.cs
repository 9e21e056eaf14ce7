#nullable enable
using System;
using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Builds a complete Humanoid character for a performer, of the performer's own sizes, and gives it to the <see cref="HumanoidDriver"/> on the same object:
    /// no model is needed to see motion. Built again when the sizes change. The figure is a child of this object and ends with this component.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Figure Builder")]
    [RequireComponent(typeof(HumanoidDriver))]
    [DefaultExecutionOrder(-50)]
    [DisallowMultipleComponent]
    public sealed class FigureBuilder : MonoBehaviour
    {
        // Sizes that are being learnt may change with every frame; a figure is a thousand objects' work.
        private const float ShortestLife = 0.5f;

        // Centimetres; less than anybody sees.
        private const float SameSize = 0.005f;

        [SerializeField]
        [Tooltip("Colours and material.")]
        private FigureLook _look = new FigureLook();

        [SerializeField]
        [Tooltip("Show a figure of usual sizes in the T-pose before there is a performer.")]
        private bool _showBeforeData = true;

        private SkeletonBody? _refused;
        private SkeletonBody? _shown;
        private float _builtAt = float.NegativeInfinity;
        private bool _isDue;

        /// <summary>A figure was built, for the first time or for other sizes. Main thread; the one before is about to be destroyed.</summary>
        public event Action<HumanoidFigure>? Built;

        /// <summary>Colours and material; of the next figure, or after <see cref="Rebuild"/>.</summary>
        public FigureLook Look
        {
            get => _look;
            set => _look = value ?? new FigureLook();
        }

        /// <summary>Whether there is a figure of usual sizes before there is a performer.</summary>
        public bool ShowBeforeData
        {
            get => _showBeforeData;
            set => _showBeforeData = value;
        }

        /// <summary>The figure; null before there is one. It is another one after sizes have changed.</summary>
        public HumanoidFigure? Figure { get; private set; }

        /// <summary>Moves the figure.</summary>
        public HumanoidDriver Driver { get; private set; } = null!;

        /// <summary>Why there is no figure of the performer's sizes; empty while all is well.</summary>
        public string Problem { get; private set; } = "";

        /// <summary>Builds the figure anew, with the look as it is now.</summary>
        public void Rebuild() => Build(Driver.Performer?.Body ?? Figure?.Body ?? SkeletonBody.GetDefault());

        private void Awake() => Driver = GetComponent<HumanoidDriver>();

        // Not built here: while an object is being activated, Unity gives it no children.
        private void OnEnable() => _isDue = true;

        private void Start() => BuildFirst();

        private void Update()
        {
            BuildFirst();
            if (!(Driver.Performer is { HasPose: true } performer))
                return;

            bool isBuilt = Figure is { IsDestroyed: false };
            SkeletonBody body = performer.Body;
            if (ReferenceEquals(body, _refused) || (isBuilt && ReferenceEquals(body, _shown)))
                return;

            // A performer who comes back brings the same sizes as another object.
            if (isBuilt && AreSame(body, Figure!.Body))
                _shown = body;
            else if (!isBuilt || Time.unscaledTime - _builtAt >= ShortestLife)
                Build(body);
        }

        private void OnDisable()
        {
            Release();
            _refused = null;
            _isDue = false;
        }

        // Of usual sizes; the performer's own replace them at once.
        private void BuildFirst()
        {
            if (!_isDue)
                return;

            _isDue = false;
            if (_showBeforeData)
                Build(SkeletonBody.GetDefault());

            _builtAt = float.NegativeInfinity;
        }

        private void Build(SkeletonBody body)
        {
            HumanoidFigure figure;
            try
            {
                figure = HumanoidFigure.Build(body, _look, transform);
            }
            catch (ArgumentException exception)
            {
                // The same body would fail in every frame; the figure before stays.
                _refused = body;
                Problem = exception.Message;
                return;
            }

            HumanoidFigure? before = Figure;
            Figure = figure;
            _shown = body;
            Problem = "";
            _refused = null;
            _builtAt = Time.unscaledTime;
            SetLayer(figure.Root.transform, gameObject.layer);
            Driver.Animator = figure.Animator;
            Built?.Invoke(figure);
            before?.Dispose();
        }

        private void Release()
        {
            if (Driver != null)
                Driver.Animator = null;

            Figure?.Dispose();
            Figure = null;
        }

        private static bool AreSame(SkeletonBody one, SkeletonBody other)
        {
            if (one.Variant != other.Variant)
                return false;

            for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
            {
                bool isSame = (one.Offsets[bone] - other.Offsets[bone]).Length() < SameSize
                    && (one.EndSites[bone] - other.EndSites[bone]).Length() < SameSize;
                if (!isSame)
                    return false;
            }

            return true;
        }

        // As the builder's object, so that cameras that leave it out leave the figure out.
        private static void SetLayer(Transform node, int layer)
        {
            node.gameObject.layer = layer;
            for (int i = 0; i < node.childCount; i++)
                SetLayer(node.GetChild(i), layer);
        }
    }
}
