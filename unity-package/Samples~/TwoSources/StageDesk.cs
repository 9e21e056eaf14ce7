#nullable enable
using UnityEngine;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>Buttons for the stages of two sources, and the way that a figure with a character controller has gone.</summary>
    public sealed class StageDesk : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("The source as it comes.")]
        private MocapSource? _source;

        [SerializeField]
        [Tooltip("The source whose stage is turned and mirrored.")]
        private MocapSource? _mirrored;

        [SerializeField]
        [Tooltip("The object with the character controller.")]
        private Transform? _walker;

        private Vector3 _start;

        /// <summary>Gets or sets the source as it comes.</summary>
        public MocapSource? Source
        {
            get => _source;
            set => _source = value;
        }

        /// <summary>Gets or sets the source whose stage is turned and mirrored.</summary>
        public MocapSource? Mirrored
        {
            get => _mirrored;
            set => _mirrored = value;
        }

        /// <summary>Gets or sets the object with the character controller.</summary>
        public Transform? Walker
        {
            get => _walker;
            set => _walker = value;
        }

        /// <summary>Makes the place and the facing of each source's performer the origin and the forward direction of its stage.</summary>
        public void Recenter()
        {
            if (_source != null)
                _source.Recenter();
            if (_mirrored != null)
                _mirrored.Recenter();
        }

        /// <summary>Undoes <see cref="Recenter"/>.</summary>
        public void ClearCenter()
        {
            if (_source != null)
                _source.ClearCenter();
            if (_mirrored != null)
                _mirrored.ClearCenter();
        }

        private void Start() => _start = _walker != null ? _walker.position : Vector3.zero;

        // The sources have a key of their own for Recenter. Clicks on the buttons below need the old Input Manager.
        private void Update()
        {
            if (KeyPresses.IsPressed(KeyCode.U))
                ClearCenter();
            if (_mirrored != null && KeyPresses.IsPressed(KeyCode.M))
                _mirrored.Stage.Mirror = !_mirrored.Stage.Mirror;
        }

        private void OnGUI()
        {
            if (_source == null || _mirrored == null || _walker == null)
                return;

            GUILayout.BeginArea(new Rect(10, 10, 320, 160));
            if (GUILayout.Button($"Recenter (key {_source.RecenterKey})"))
                Recenter();
            if (GUILayout.Button("Undo Recenter (key U)"))
                ClearCenter();

            _mirrored.Stage.Mirror = GUILayout.Toggle(_mirrored.Stage.Mirror, "Mirror (key M)");
            GUILayout.Label($"The walker is {(_walker.position - _start).magnitude:0.0} m from its start.");
            GUILayout.EndArea();
        }
    }
}
