#nullable enable
using System.Collections.Generic;
using System.Globalization;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Lists the performers of one source, or of all, over the game view: frame rate, delay, jitter and late frames of each. The delay counts from the arrival of a
    /// frame. The smoothing of a figure adds its own delay, which the figure's driver shows.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Performer Overlay")]
    [HelpURL(HelpPage.Components + "#performer-overlay")]
    [DefaultExecutionOrder(500)]
    public sealed class PerformerOverlay : MonoBehaviour
    {
        private const float Width = 480;
        private const float LineHeight = 24;

        [SerializeField]
        [Tooltip("The source whose performers are listed. Empty: all sources in the scene.")]
        private MocapSource? _source;

        [SerializeField]
        [Tooltip("Place of the list in the game view, in pixels from the upper left corner.")]
        private Vector2 _position = new Vector2(10, 10);

        [SerializeField]
        [Range(0.1f, 5)]
        [Tooltip("Seconds from one update of the numbers to the next.")]
        private float _interval = 0.5f;

        private readonly List<string> _lines = new List<string>();
        private float _nextUpdate;

        /// <summary>Gets or sets the source whose performers are listed. Null: all of <see cref="MocapSource.All"/>, with their names if there are several.</summary>
        public MocapSource? Source
        {
            get => _source;
            set => _source = value;
        }

        /// <summary>Gets or sets the place of the list, in pixels from the upper left corner of the game view.</summary>
        public Vector2 Position
        {
            get => _position;
            set => _position = value;
        }

        /// <summary>Gets or sets the seconds from one update of the numbers to the next, 0.1 to 5. The default is 0.5.</summary>
        public float Interval
        {
            get => _interval;
            set => _interval = Mathf.Clamp(value, 0.1f, 5);
        }

        /// <summary>Gets the lines as of the last update.</summary>
        public IReadOnlyList<string> Lines => _lines;

        // Layout takes memory in every frame.
        private void Awake() => useGUILayout = false;

        private void OnEnable() => _nextUpdate = 0;

        private void OnDisable() => _lines.Clear();

        // The text is created a few times a second, because each text takes memory.
        private void Update()
        {
            float now = Time.unscaledTime;
            if (now < _nextUpdate)
                return;

            _nextUpdate = now + _interval;
            _lines.Clear();
            if (_source != null)
            {
                List(_source, string.Empty);
                return;
            }

            for (int i = 0; i < MocapSource.All.Count; i++)
                List(MocapSource.All[i], MocapSource.All.Count > 1 ? MocapSource.All[i].name + ": " : string.Empty);
        }

        private void List(MocapSource source, string prefix)
        {
            if (source.Performers.Count == 0)
                _lines.Add(prefix + source.StatusMessage);
            for (int i = 0; i < source.Performers.Count; i++)
                _lines.Add(prefix + Describe(source.Performers[i]));
        }

        private void OnGUI()
        {
            for (int i = 0; i < _lines.Count; i++)
                GUI.Label(new Rect(_position.x, _position.y + (i * LineHeight), Width, LineHeight), _lines[i]);
        }

        private static string Describe(Performer performer) => performer.IsLive
            ? $"{performer}: {Number(performer.FrameRate, "0.0")} /s, delay {Milliseconds(performer.Latency)} ms, jitter {Milliseconds(performer.Jitter)} ms, "
                + $"{Number(performer.LateFrames, "0")} late"
            : $"{performer}: no frame for {Number(performer.SecondsSinceFrame, "0")} s";

        private static string Milliseconds(float seconds) => Number(seconds * 1000, "0.0");

        private static string Number(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);
    }
}
