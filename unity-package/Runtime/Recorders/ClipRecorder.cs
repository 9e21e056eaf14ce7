#nullable enable
using System;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Records a character into an animation clip, after all components have moved it. Only the editor can save clips. In a player,
    /// <see cref="MotionRecorder"/> writes BVH. Use it on the main thread.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Clip Recorder")]
    [HelpURL(HelpPage.Components + "#clip-recorder")]
    [DefaultExecutionOrder(1000)]
    public sealed partial class ClipRecorder : TakeRecorder
    {
        [SerializeField]
        [Tooltip("The character. Empty: the one on this object, or below it.")]
        private Animator? _animator;

        [SerializeField]
        [Tooltip("Humanoid clips play on every Humanoid. Generic clips are exact and play on the same transforms only.")]
        private ClipKind _kind = ClipKind.Humanoid;

        [SerializeField]
        [Tooltip("Generic clips: the bone that moves the character. Empty: the hips of the avatar or of a driver, or else the object's first child.")]
        private Transform? _hips;

        [SerializeField]
        [Range(1, 240)]
        [Tooltip("Maximum frame rate of the clip. It never exceeds the rate of the game.")]
        private float _frameRate = 60;

        [SerializeField]
        [Range(0, 1)]
        [Tooltip("Removes keys that interpolation restores within this error: percent of a muscle's range, degrees, or centimetres. 0 keeps all.")]
        private float _keyTolerance = 0.1f;

        [SerializeField]
        [Tooltip("Folder below Assets where clips are saved.")]
        private string _folder = "Recordings";

        /// <summary>Occurs when a take has ended, before it is saved. Main thread.</summary>
        public event Action<ClipTake>? Finished;

        // Set by the editor part of the package: saves a take and returns the asset's path.
        internal static Func<ClipRecorder, ClipTake, string>? Saver { get; set; }

        /// <summary>Gets or sets the character. Null: the one on this object, or below it.</summary>
        public Animator? Animator
        {
            get => _animator;
            set => _animator = value;
        }

        /// <summary>Gets or sets the kind of the next take.</summary>
        public ClipKind Kind
        {
            get => _kind;
            set => _kind = value;
        }

        /// <summary>
        /// Gets or sets the bone that moves the character in generic clips. Null: the hips of the avatar or of a driver, or else the first child.
        /// </summary>
        public Transform? Hips
        {
            get => _hips;
            set => _hips = value;
        }

        /// <summary>Gets or sets the maximum frame rate of the clip, 1 to 240.</summary>
        public float FrameRate
        {
            get => _frameRate;
            set => _frameRate = Mathf.Clamp(value, 1, 240);
        }

        /// <summary>
        /// Gets or sets the error allowed when keys are removed: percent of a muscle's range, degrees or centimetres, 0 to 1. A larger error needs
        /// fewer keys.
        /// </summary>
        public float KeyTolerance
        {
            get => _keyTolerance;
            set => _keyTolerance = Mathf.Clamp01(value);
        }

        /// <summary>Gets or sets the folder below Assets.</summary>
        public string Folder
        {
            get => _folder;
            set => _folder = value ?? "";
        }

        /// <inheritdoc/>
        public override bool IsRecording => _sampler is { };

        /// <inheritdoc/>
        public override double Elapsed => Take?.Length ?? 0;

        /// <summary>Gets the current or last take. Null before the first take.</summary>
        public ClipTake? Take { get; private set; }

        /// <summary>Gets the path of the last take's asset, such as "Assets/Recordings/Ann.anim". Empty before the first asset.</summary>
        public string SavedPath { get; private set; } = "";
    }
}
