#nullable enable
using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Events;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Makes a figure for each performer of a source: of a prefab, or one of the performer's own sizes when there is none. Figures whose data stops become
    /// idle, and are destroyed after a while. Main thread.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Performer Spawner")]
    [DefaultExecutionOrder(200)]
    public sealed class PerformerSpawner : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("The source whose performers get figures.")]
        private MocapSource? _source;

        [SerializeField]
        [Tooltip("A character with an Animator and a humanoid avatar, or with its own driver. Empty: a figure of simple shapes in each performer's sizes.")]
        private GameObject? _prefab;

        [SerializeField]
        [Range(1, 64)]
        [Tooltip("Maximum number of figures at a time. More performers have to wait.")]
        private int _maxFigures = 16;

        [SerializeField]
        [Tooltip("One stage for all, as the performers stood; or a stage for each, in a row or a grid.")]
        private FigurePlacement _placement = FigurePlacement.SharedStage;

        [SerializeField]
        [Min(0)]
        [Tooltip("Distance between the stages of a row or grid; metres.")]
        private float _spacing = 1.5f;

        [SerializeField]
        [Range(1, 16)]
        [Tooltip("Figures in each row of a grid.")]
        private int _columns = 4;

        [SerializeField]
        [Tooltip("What a figure does while its performer's data has stopped.")]
        private IdlePose _idlePose = IdlePose.Stand;

        [SerializeField]
        [Range(0, 5)]
        [Tooltip("Seconds that a figure takes to blend to the idle pose and back.")]
        private float _blendSeconds = 0.5f;

        [SerializeField]
        [Min(0)]
        [Tooltip("Destroy a figure after this many idle seconds. 0: never.")]
        private float _despawnSeconds = 10;

        [SerializeField]
        [Tooltip("A figure was made.")]
        private UnityEvent<GameObject> _onSpawned = new UnityEvent<GameObject>();

        [SerializeField]
        [Tooltip("A figure is about to be destroyed.")]
        private UnityEvent<GameObject> _onDespawning = new UnityEvent<GameObject>();

        private readonly List<SpawnedFigure> _figures = new List<SpawnedFigure>();
        private bool _isFull;
        private GameObject? _badPrefab;

        /// <summary>A figure was made. Main thread.</summary>
        public event Action<SpawnedFigure>? Spawned;

        /// <summary>A figure is about to be destroyed. Main thread.</summary>
        public event Action<SpawnedFigure>? Despawning;

        /// <summary>A figure's data stopped, or came back: <see cref="SpawnedFigure.IsIdle"/>. Main thread.</summary>
        public event Action<SpawnedFigure>? IdleChanged;

        /// <summary>The source whose performers get figures.</summary>
        public MocapSource? Source
        {
            get => _source;
            set => _source = value;
        }

        /// <summary>What figures are made of: a character with a humanoid Animator, or with a driver of its own. Null: built figures. Of those made from now on.</summary>
        public GameObject? Prefab
        {
            get => _prefab;
            set => _prefab = value;
        }

        /// <summary>Most figures at a time, 1 to 64.</summary>
        public int MaxFigures
        {
            get => _maxFigures;
            set => _maxFigures = Mathf.Clamp(value, 1, 64);
        }

        /// <summary>Where figures are put. Of those made from now on.</summary>
        public FigurePlacement Placement
        {
            get => _placement;
            set => _placement = value;
        }

        /// <summary>Distance between the stages of a row or grid; metres.</summary>
        public float Spacing
        {
            get => _spacing;
            set => _spacing = Mathf.Max(0, value);
        }

        /// <summary>Figures in each row of a grid, 1 to 16.</summary>
        public int Columns
        {
            get => _columns;
            set => _columns = Mathf.Clamp(value, 1, 16);
        }

        /// <summary>What a figure does while its performer's data has stopped.</summary>
        public IdlePose IdlePose
        {
            get => _idlePose;
            set => _idlePose = value;
        }

        /// <summary>How long a figure takes to the idle pose and back; seconds.</summary>
        public float BlendSeconds
        {
            get => _blendSeconds;
            set => _blendSeconds = Mathf.Max(0, value);
        }

        /// <summary>After how long figures that are idle are destroyed; seconds, 0 for never.</summary>
        public float DespawnSeconds
        {
            get => _despawnSeconds;
            set => _despawnSeconds = Mathf.Max(0, value);
        }

        /// <summary>The figures there are, in the order in which they were made.</summary>
        public IReadOnlyList<SpawnedFigure> Figures => _figures;

        /// <summary>Why a performer has no figure, with what to change; empty while all is well.</summary>
        public string Problem { get; private set; } = "";

        /// <summary>Destroys all figures. Performers that are live get new ones.</summary>
        public void DespawnAll()
        {
            while (_figures.Count > 0)
                Despawn(_figures[_figures.Count - 1]);
        }

        private void Update()
        {
            if (_source != null)
                SpawnMissing(_source.Performers);

            // Handlers may disable the spawner, which empties the list.
            for (int i = _figures.Count - 1; i >= 0; i--)
            {
                if (i < _figures.Count)
                    Watch(_figures[i]);
            }
        }

        private void LateUpdate()
        {
            float step = _blendSeconds > 0 ? Time.unscaledDeltaTime / _blendSeconds : 1;
            for (int i = 0; i < _figures.Count; i++)
                _figures[i].Apply(step);
        }

        private void OnDisable() => DespawnAll();

        private void SpawnMissing(IReadOnlyList<Performer> performers)
        {
            bool isFull = false;
            for (int i = 0; i < performers.Count && isActiveAndEnabled; i++)
            {
                Performer performer = performers[i];
                if (!performer.HasPose || !performer.IsLive)
                    continue;

                if (Find(performer) is { } known)
                    known.Performer = performer;
                else if (_figures.Count < _maxFigures)
                    Spawn(performer);
                else
                    isFull = true;
            }

            if (isFull != _isFull)
                Problem = isFull ? $"There are more performers than {_maxFigures} figures: raise Max Figures." : "";

            _isFull = isFull;
        }

        private void Spawn(Performer performer)
        {
            // Not in every frame anew.
            if (_prefab != null && _prefab == _badPrefab)
                return;

            int place = FindPlace();
            GameObject? root = _prefab == null ? CreateBuilt(performer) : CreateFromPrefab(_prefab);
            if (root == null)
                return;

            FigureDriver driver = root.GetComponentInChildren<FigureDriver>(true);
            driver.Source = _source;
            driver.PerformerChoice = PerformerChoice.ByIndex;
            driver.PerformerIndex = performer.AvatarIndex;
            root.name = $"{performer.Name} ({performer.AvatarIndex})";
            root.transform.SetParent(transform, false);
            root.transform.localPosition = GetPosition(place);
            root.SetActive(true);

            if (!_isFull)
                Problem = "";

            var figure = new SpawnedFigure(root, driver, performer, place);
            _figures.Add(figure);
            Spawned?.Invoke(figure);
            _onSpawned.Invoke(root);
        }

        // Not active before all is set: it would look for a source of its own.
        private static GameObject CreateBuilt(Performer performer)
        {
            var root = new GameObject();
            root.SetActive(false);
            root.AddComponent<HumanoidDriver>();
            FigureBuilder builder = root.AddComponent<FigureBuilder>();
            builder.Look = FigureLook.Numbered(performer.AvatarIndex);
            builder.ShowBeforeData = false;
            return root;
        }

        private GameObject? CreateFromPrefab(GameObject prefab)
        {
            GameObject root = Instantiate(prefab);
            if (root.GetComponentInChildren<FigureDriver>(true) != null)
                return root;

            Animator animator = root.GetComponentInChildren<Animator>(true);
            if (animator != null && animator.isHuman)
            {
                root.AddComponent<HumanoidDriver>().Animator = animator;
                return root;
            }

            Problem = $"The prefab \"{prefab.name}\" has neither a driver nor an Animator with a humanoid avatar: set the model's Animation Type to Humanoid.";
            Destroy(root);
            _badPrefab = prefab;
            return null;
        }

        private void Watch(SpawnedFigure figure)
        {
            if (figure.IsDestroyed)
            {
                _figures.Remove(figure);
                return;
            }

            if (figure.Update(figure.Performer.IsLive && IsPresent(figure.Performer), _idlePose, _blendSeconds, Time.unscaledDeltaTime))
                IdleChanged?.Invoke(figure);

            if (_despawnSeconds > 0 && figure.IdleSeconds >= _despawnSeconds)
                Despawn(figure);
        }

        private void Despawn(SpawnedFigure figure)
        {
            if (!_figures.Remove(figure) || figure.IsDestroyed)
                return;

            Despawning?.Invoke(figure);
            _onDespawning.Invoke(figure.Root);
            Disposal.Destroy(figure.Root);
        }

        // Of a performer that left its source nothing is kept up to date.
        private bool IsPresent(Performer performer)
        {
            if (_source == null)
                return false;

            IReadOnlyList<Performer> performers = _source.Performers;
            for (int i = 0; i < performers.Count; i++)
            {
                if (ReferenceEquals(performers[i], performer))
                    return true;
            }

            return false;
        }

        private SpawnedFigure? Find(Performer performer)
        {
            foreach (SpawnedFigure figure in _figures)
            {
                if (figure.Performer.AvatarIndex == performer.AvatarIndex && figure.Performer.Sender == performer.Sender)
                    return figure;
            }

            return null;
        }

        // The first that is free, so that nobody changes places when somebody leaves.
        private int FindPlace()
        {
            for (int place = 0; ; place++)
            {
                if (!_figures.Exists(figure => figure.Place == place))
                    return place;
            }
        }

        private Vector3 GetPosition(int place) => _placement switch
        {
            // 0, right, left, further right and so on.
            FigurePlacement.Row => new Vector3(_spacing * ((place + 1) / 2) * (place % 2 == 1 ? 1 : -1), 0, 0),
            FigurePlacement.Grid => new Vector3(
                _spacing * ((place % _columns) - ((_columns - 1) / 2f)),
                0,
                -_spacing * (place / _columns)),
            _ => Vector3.zero,
        };
    }
}
