#nullable enable
using System;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>The common part of <see cref="MotionRecorder"/> and <see cref="ClipRecorder"/>. Use it on the main thread.</summary>
    public abstract class TakeRecorder : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Name of the takes: {name} in File Name.")]
        private string _takeName = TakeLabel.DefaultName;

        [SerializeField]
        [Min(1)]
        [Tooltip("Number of the next take: {take} in File Name. Counts up after each take, and skips numbers that files of the folder have.")]
        private int _slate = 1;

        [SerializeField]
        [Tooltip("Name of the files, without extension. {source} is the name of the source or character; {name}, {take} (001, 002 ...), {date} and {time} are replaced.")]
        private string _fileName = TakeFileName.DefaultPattern;

        [SerializeField]
        [Tooltip("Start a take when play mode, or the scene, starts.")]
        private bool _recordOnPlay;

        private TakeLabel? _label;

        private protected TakeRecorder()
        {
        }

        /// <summary>Gets or sets the name of the takes, <c>{name}</c> in <see cref="FileName"/>. Empty: the default, <c>Take</c>.</summary>
        public string TakeName
        {
            get => _takeName;
            set => _takeName = value ?? "";
        }

        /// <summary>
        /// Gets or sets the number of the next take, <c>{take}</c> in <see cref="FileName"/>, from 1. Numbers that files of the folder have are skipped.
        /// It counts up when a take has written its files, and during play mode only: Unity restores fields at its end.
        /// </summary>
        public int Slate
        {
            get => _slate;
            set => _slate = Mathf.Max(1, value);
        }

        /// <summary>Gets or sets the name of the next take's files, a pattern for <see cref="TakeFileName"/>.</summary>
        public string FileName
        {
            get => _fileName;
            set => _fileName = value ?? "";
        }

        /// <summary>Gets or sets whether a take starts with play mode, or with the scene.</summary>
        public bool RecordOnPlay
        {
            get => _recordOnPlay;
            set => _recordOnPlay = value;
        }

        /// <summary>Gets whether a take is being recorded, or waits for its source to open.</summary>
        public abstract bool IsRecording { get; }

        /// <summary>Gets the duration of the current or last take, in seconds.</summary>
        public abstract double Elapsed { get; }

        /// <summary>Gets the reason why nothing, or not everything, is recorded or saved. Empty if there is no problem.</summary>
        public string Problem { get; private protected set; } = "";

        /// <summary>Starts a take. If a source is needed and not open yet, the take waits for it.</summary>
        /// <returns>False if it cannot start; <see cref="Problem"/> then says why.</returns>
        public bool StartRecording()
        {
            Problem = IsRecording ? "A take is already being recorded."
                : !Application.isPlaying ? "Takes are recorded in play mode only."
                : !isActiveAndEnabled ? "The recorder is disabled."
                : Begin();
            return Problem.Length == 0;
        }

        /// <summary>Ends the take. Its files may be complete a moment later.</summary>
        public abstract void StopRecording();

        // source: the value of {source}.
        internal TakeLabel Label(string source) => _label = new TakeLabel(_fileName, source, _takeName, _slate, DateTime.Now);

        // After a take whose files have a name.
        private protected void CountUp()
        {
            if (_label is { Number: > 0 } label)
                Slate = label.Number + 1;

            _label = null;
        }

        // Returns the reason why the take cannot start, or an empty text.
        private protected abstract string Begin();

        private void Start()
        {
            if (_recordOnPlay)
                StartOrWarn();
        }

        // Without a caller who reads the problem.
        [ContextMenu("Start recording")]
        private void StartOrWarn()
        {
            if (!StartRecording())
                Debug.LogWarning($"Nothing is recorded. {Problem}", this);
        }

        [ContextMenu("Stop recording")]
        private void Stop() => StopRecording();
    }
}
