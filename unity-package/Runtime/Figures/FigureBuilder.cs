#nullable enable
using System;
using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Builds a complete Humanoid character in the performer's own sizes for the <see cref="HumanoidDriver"/> on the same object. No model is needed
    /// to see motion. The figure is built again when the sizes change. It is a child of this object and is destroyed with this component.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Figure Builder")]
    [HelpURL(HelpPage.Components + "#figure-builder")]
    [RequireComponent(typeof(HumanoidDriver))]
    [DefaultExecutionOrder(-50)]
    [DisallowMultipleComponent]
    public sealed class FigureBuilder : MonoBehaviour
    {
        // While sizes are being learnt, they may change with every frame. Building a figure is expensive.
        private const float ShortestLife = 0.5f;

        // In centimetres. Smaller differences are not visible.
        private const float SameSize = 0.005f;

        [SerializeField]
        [Tooltip("Colours and material.")]
        private FigureLook _look = new FigureLook();

        [SerializeField]
        [Tooltip("Show a figure with default sizes in the T-pose before there is a performer.")]
        private bool _showBeforeData = true;

        private SkeletonBody? _refused;
        private SkeletonBody? _shown;
        private float _builtAt = float.NegativeInfinity;
        private bool _isDue;

        /// <summary>
        /// Occurs when a figure has been built, for the first time or for other sizes. Main thread. The previous figure is about to be destroyed.
        /// </summary>
        public event Action<HumanoidFigure>? Built;

        /// <summary>Gets or sets colours and material. They apply to the next figure, or after <see cref="Rebuild"/>.</summary>
        public FigureLook Look
        {
            get => _look;
            set => _look = value ?? new FigureLook();
        }

        /// <summary>Gets or sets whether a figure with default sizes is shown before there is a performer.</summary>
        public bool ShowBeforeData
        {
            get => _showBeforeData;
            set => _showBeforeData = value;
        }

        /// <summary>Gets the figure, or null before it is built. It is another object after sizes change.</summary>
        public HumanoidFigure? Figure { get; private set; }

        /// <summary>Gets the driver that moves the figure.</summary>
        public HumanoidDriver Driver { get; private set; } = null!;

        /// <summary>Gets the reason why there is no figure in the performer's sizes. Empty if there is no problem.</summary>
        public string Problem { get; private set; } = "";

        /// <summary>
        /// Builds the figure again, with the current look. It does nothing while this component or its object is disabled: the figure is built, with the
        /// current look, when they are enabled.
        /// </summary>
        public void Rebuild()
        {
            // An object that was never active has no driver yet.
            if (isActiveAndEnabled && Driver != null)
                Build(Driver.Performer?.Body ?? Figure?.Body ?? SkeletonBody.GetDefault());
        }

        private void Awake() => Driver = GetComponent<HumanoidDriver>();

        // Not built here, because Unity does not allow new children while an object is being activated.
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

            // A performer who returns has the same sizes in a new object.
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

        // With default sizes. The performer's own sizes replace them at once.
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
                // The same body would fail in every frame. The previous figure stays.
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
            Handlers.Raise(Built, figure, this);
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

        // The figure has the layer of the builder's object, so cameras that exclude that layer exclude the figure.
        private static void SetLayer(Transform node, int layer)
        {
            node.gameObject.layer = layer;
            for (int i = 0; i < node.childCount; i++)
                SetLayer(node.GetChild(i), layer);
        }
    }
}
