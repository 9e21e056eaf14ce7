#nullable enable
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>The common part of <see cref="MotionRecorder"/> and <see cref="ClipRecorder"/>. Use it on the main thread.</summary>
    public abstract class TakeRecorder : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Name of the files, without extension. {source} is the name of the source or character; {date}, {time} and {take} (001, 002 ...) are replaced.")]
        private string _fileName = TakeFileName.DefaultPattern;

        [SerializeField]
        [Tooltip("Start a take when play mode, or the scene, starts.")]
        private bool _recordOnPlay;

        private protected TakeRecorder()
        {
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
