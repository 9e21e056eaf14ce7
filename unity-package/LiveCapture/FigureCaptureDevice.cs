#nullable enable

using System.Diagnostics;
using Unity.LiveCapture;
using UnityEngine;
using LiveRecorder = Unity.LiveCapture.TakeRecorder;

namespace NeuronMocap.Unity.LiveCapture
{
    /// <summary>
    /// Records a figure in the Take Recorder of Unity's package Live Capture, together with its other devices. It needs Live Capture 4 and an
    /// Animator. In edit mode, switch on the preview of the figure's source first. Use it on the main thread.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Figure Capture Device")]
    [CreateDeviceMenuItem("NeuronMocap Figure Device")]
    [HelpURL(HelpPage.Components + "#figure-capture-device")]
    [DefaultExecutionOrder(1000)]
    public sealed class FigureCaptureDevice : LiveCaptureDevice
    {
        // A frame that comes slightly early is taken anyway.
        private const double EarlyPart = 0.25;

        [Tooltip("The figure that is recorded. A Humanoid gets a clip that plays on every Humanoid, another figure one for its own transforms.")]
        [SerializeField]
        private FigureDriver? _figure;

        [Tooltip("Removes keys that interpolation restores within this error: percent of a muscle's range, degrees, or centimetres. 0 keeps all.")]
        [Range(0, 1)]
        [SerializeField]
        private float _keyTolerance = 0.1f;

        private readonly Stopwatch _clock = new Stopwatch();
        private Animator? _animator;
        private ClipSampler? _sampler;
        private ClipTake? _take;
        private double _next;

        /// <summary>Gets or sets the figure that is recorded.</summary>
        public FigureDriver? Figure
        {
            get => _figure;
            set => _figure = value;
        }

        /// <summary>
        /// Gets or sets the error allowed when keys are removed: percent of a muscle's range, degrees or centimetres, 0 to 1. A larger error needs
        /// fewer keys. The default is 0.1.
        /// </summary>
        public float KeyTolerance
        {
            get => _keyTolerance;
            set => _keyTolerance = Mathf.Clamp01(value);
        }

        /// <summary>Gets why the figure is not recorded, and what to change. Empty if there is no problem.</summary>
        public string Problem { get; private set; } = string.Empty;

        /// <summary>Gets whether the figure follows a live performer and has an Animator. Otherwise <see cref="Problem"/> says what is missing.</summary>
        /// <returns>True if the figure can be recorded now.</returns>
        public override bool IsReady()
        {
            Problem = _figure == null ? "Set Figure to the driver of the figure that is recorded."
                : FindAnimator() == null ? $"\"{_figure.name}\" has no Animator. Add one: the take is bound to it."
                : _figure.IsDriving ? string.Empty
                : _figure.Problem.Length > 0 ? _figure.Problem
                : "The figure does not follow a performer. In edit mode, switch Preview on at its source.";
            return Problem.Length == 0;
        }

        /// <summary>Adds the recorded clip to the take. The Take Recorder calls it in the editor.</summary>
        /// <param name="takeBuilder">The take.</param>
        public override void Write(ITakeBuilder takeBuilder)
        {
            if (_take is { FrameCount: > 0 } take && _animator != null && ClipTake.Writer is { } write)
                takeBuilder.CreateAnimationTrack(_animator.name, _animator, write(take, _keyTolerance));
        }

        /// <summary>Starts a take.</summary>
        protected override void OnStartRecording()
        {
            // Figure may change during the take, which belongs to this character.
            _take = null;
            _animator = IsReady() ? FindAnimator() : null;
            if (!(_animator is { } animator))
                return;

            ClipKind kind = animator.isHuman ? ClipKind.Humanoid : ClipKind.Generic;
            Transform? hips = kind == ClipKind.Generic ? _figure!.FindHips() : null;
            _sampler = ClipSamplers.Create(kind, animator, animator.transform, hips, out string problem);
            Problem = problem;
            if (_sampler is null)
                return;

            _take = new ClipTake(_sampler.Properties, kind == ClipKind.Humanoid, (float)(1 / LiveRecorder.FrameRate.FrameInterval));
            _next = 0;
            _clock.Restart();
        }

        /// <summary>Ends the take.</summary>
        protected override void OnStopRecording()
        {
            _clock.Stop();
            _sampler?.Dispose();
            _sampler = null;
        }

        // The figure has moved: in play mode by its driver, and in edit mode by the preview of its source.
        private void LateUpdate()
        {
            if (_sampler is null || _take is null || _sampler.IsGone)
                return;

            double time = _take.FrameCount > 0 ? _clock.Elapsed.TotalSeconds : 0;
            double period = 1 / _take.FrameRate;
            if (time < _next - (EarlyPart * period))
                return;

            _next = System.Math.Max(_next + period, time);
            _sampler.Sample();
            _take.Add((float)time, _sampler.Values);
        }

        private Animator? FindAnimator()
        {
            if (_figure == null)
                return null;

            Animator? own = _figure is HumanoidDriver humanoid ? humanoid.ActiveAnimator : null;
            if (own == null)
                own = _figure.GetComponentInChildren<Animator>();

            return own != null ? own : null;
        }
    }
}
