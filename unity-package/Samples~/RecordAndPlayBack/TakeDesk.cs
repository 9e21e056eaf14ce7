#nullable enable
using System;
using System.Collections.Generic;
using UnityEngine;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>Records a performer, then plays the take on a second figure beside the first.</summary>
    public sealed class TakeDesk : MonoBehaviour
    {
        private const string RecordingExtension = ".nmrec";

        [SerializeField]
        [Tooltip("Records the live source.")]
        private MotionRecorder? _recorder;

        [SerializeField]
        [Tooltip("A disabled source, which plays the take.")]
        private MocapSource? _playback;

        [SerializeField]
        [Range(0, 60)]
        [Tooltip("Records automatically at the start for this many seconds. 0: never.")]
        private float _recordAtStart = 5;

        private string _take = "";

        /// <summary>Gets or sets the recorder of the live source.</summary>
        public MotionRecorder? Recorder
        {
            get => _recorder;
            set => _recorder = value;
        }

        /// <summary>Gets or sets the source that plays the take.</summary>
        public MocapSource? Playback
        {
            get => _playback;
            set => _playback = value;
        }

        /// <summary>Gets or sets how long to record automatically at the start, in seconds.</summary>
        public float RecordAtStart
        {
            get => _recordAtStart;
            set => _recordAtStart = value;
        }

        /// <summary>Gets the path of the recording that is played. Empty before the first recording.</summary>
        public string Take => _take;

        private void OnEnable()
        {
            if (_recorder != null)
                _recorder.Finished += Play;
        }

        private void Start()
        {
            if (_recorder != null && _recordAtStart > 0)
                Record();
        }

        private void OnDisable()
        {
            if (_recorder != null)
                _recorder.Finished -= Play;
        }

        private void Update()
        {
            if (_recordAtStart > 0 && _recorder != null && _recorder.State == RecorderState.Recording && _recorder.Elapsed >= _recordAtStart)
            {
                _recordAtStart = 0;
                _recorder.StopRecording();
            }

            // Clicks on the button below need the old Input Manager.
            if (KeyPresses.IsPressed(KeyCode.R))
                Toggle();
        }

        private void OnGUI()
        {
            if (_recorder == null)
                return;

            GUILayout.BeginArea(new Rect(10, 10, 420, 120));
            bool isRecording = _recorder.State == RecorderState.Recording;
            if (GUILayout.Button(isRecording ? "Stop and play (key R)" : "Record (key R)"))
                Toggle();

            GUILayout.Label(isRecording ? $"{_recorder.Elapsed:0.0} s, {_recorder.Frames} frames, {_recorder.Bytes / 1024} KiB" : _take);
            GUILayout.Label(_recorder.Problem);
            GUILayout.EndArea();
        }

        private void Toggle()
        {
            if (_recorder == null)
                return;

            if (_recorder.State == RecorderState.Recording)
                _recorder.StopRecording();
            else
                Record();
        }

        private void Record()
        {
            // BVH for animation programs, and a recording that plays like the stream.
            _recorder!.Formats = TakeFormats.Bvh | TakeFormats.Recording;
            _recorder.StartRecording();
        }

        private void Play(IReadOnlyList<string> files)
        {
            foreach (string file in files)
            {
                if (file.EndsWith(RecordingExtension, StringComparison.Ordinal))
                    _take = file;
            }

            if (_playback == null || _take.Length == 0)
                return;

            _playback.Kind = SourceKind.Recording;
            _playback.File = _take;
            _playback.Loop = true;
            _playback.enabled = true;
        }
    }
}
