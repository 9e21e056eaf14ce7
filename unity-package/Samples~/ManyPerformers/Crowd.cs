#nullable enable
using UnityEngine;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>Adds and removes performers, and shows how many there are.</summary>
    public sealed class Crowd : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("The source, whose simulator creates the performers.")]
        private MocapSource? _source;

        [SerializeField]
        [Tooltip("Creates a figure for each performer.")]
        private PerformerSpawner? _spawner;

        private string _message = "";

        /// <summary>Gets or sets the source.</summary>
        public MocapSource? Source
        {
            get => _source;
            set => _source = value;
        }

        /// <summary>Gets or sets the spawner that creates the figures.</summary>
        public PerformerSpawner? Spawner
        {
            get => _spawner;
            set => _spawner = value;
        }

        /// <summary>Adds or removes performers.</summary>
        /// <param name="difference">The number to add. A negative number removes performers.</param>
        public void Change(int difference)
        {
            if (_source != null)
                _source.PerformerCount = Mathf.Clamp(_source.PerformerCount + difference, 1, 16);
        }

        private void OnEnable()
        {
            if (_spawner == null)
                return;

            _spawner.Spawned += OnSpawned;
            _spawner.Despawning += OnDespawning;
        }

        private void OnDisable()
        {
            if (_spawner == null)
                return;

            _spawner.Spawned -= OnSpawned;
            _spawner.Despawning -= OnDespawning;
        }

        // Clicks on the buttons below need the old Input Manager.
        private void Update()
        {
            if (KeyPresses.IsPressed(KeyCode.M))
                Change(1);
            if (KeyPresses.IsPressed(KeyCode.F))
                Change(-1);
        }

        private void OnGUI()
        {
            if (_source == null || _spawner == null)
                return;

            GUILayout.BeginArea(new Rect(10, 10, 260, 120));
            GUILayout.Label($"{_spawner.Figures.Count} figures of {_source.PerformerCount} performers");
            GUILayout.BeginHorizontal();
            if (GUILayout.Button("One more (key M)"))
                Change(1);
            if (GUILayout.Button("One fewer (key F)"))
                Change(-1);

            GUILayout.EndHorizontal();
            GUILayout.Label(_message);
            GUILayout.EndArea();
        }

        private void OnSpawned(SpawnedFigure figure) => _message = figure.Performer.Name + " has come";

        private void OnDespawning(SpawnedFigure figure) => _message = figure.Performer.Name + " has gone";
    }
}
