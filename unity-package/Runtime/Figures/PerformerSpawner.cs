#nullable enable
using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Events;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Creates a figure for each performer of a source: from a prefab, or in the performer's own sizes if there is no prefab. Figures become idle
    /// when their data stops, and are destroyed after a while. Use it on the main thread.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Performer Spawner")]
    [HelpURL(HelpPage.Components + "#performer-spawner")]
    [DefaultExecutionOrder(200)]
    public sealed class PerformerSpawner : MonoBehaviour
    {
        private const string NoSource = "Set Source to the Mocap Source whose performers get figures.";

        [SerializeField]
        [Tooltip("The source whose performers get figures.")]
        private MocapSource? _source;

        [SerializeField]
        [Tooltip("A character with an Animator and a Humanoid avatar, or with its own driver. Empty: a figure of simple shapes in each performer's sizes.")]
        private GameObject? _prefab;

        [SerializeField]
        [Tooltip("A material to copy and colour for figures without a prefab. Empty: the lit material of the render pipeline, which builds of the scene include.")]
        private Material? _material;

        [SerializeField]
        [Range(1, 64)]
        [Tooltip("Maximum number of figures at a time. Further performers wait.")]
        private int _maxFigures = 16;

        [SerializeField]
        [Tooltip("One stage for all, as the performers stood; or a stage for each, in a row or a grid.")]
        private FigurePlacement _placement = FigurePlacement.SharedStage;

        [SerializeField]
        [Min(0)]
        [Tooltip("Distance between the stages of a row or grid, in metres.")]
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
        [Tooltip("Called when a figure has been created.")]
        private UnityEvent<GameObject> _onSpawned = new UnityEvent<GameObject>();

        [SerializeField]
        [Tooltip("Called when a figure is about to be destroyed.")]
        private UnityEvent<GameObject> _onDespawning = new UnityEvent<GameObject>();

        private readonly List<SpawnedFigure> _figures = new List<SpawnedFigure>();
        private MocapSource? _shownSource;
        private bool _isFull;
        private GameObject? _badPrefab;

        /// <summary>Occurs when a figure has been created. Main thread.</summary>
        public event Action<SpawnedFigure>? Spawned;

        /// <summary>Occurs when a figure is about to be destroyed. Main thread.</summary>
        public event Action<SpawnedFigure>? Despawning;

        /// <summary>Occurs when a figure's data stops or resumes; see <see cref="SpawnedFigure.IsIdle"/>. Main thread.</summary>
        public event Action<SpawnedFigure>? IdleChanged;

        /// <summary>Gets or sets the source whose performers get figures. Another source replaces the figures; null keeps them.</summary>
        public MocapSource? Source
        {
            get => _source;
            set => _source = value;
        }

        /// <summary>
        /// Gets or sets the character to copy for each figure, with a Humanoid Animator or its own driver. Null: built figures. Affects figures
        /// created later.
        /// </summary>
        public GameObject? Prefab
        {
            get => _prefab;
            set => _prefab = value;
        }

        /// <summary>
        /// Gets or sets a material to copy and colour for figures without a prefab. Null: the lit material of the render pipeline, which builds of the
        /// scene include. Affects figures created later.
        /// </summary>
        public Material? Material
        {
            get => _material;
            set => _material = value;
        }

        /// <summary>Gets or sets the maximum number of figures at a time, 1 to 64.</summary>
        public int MaxFigures
        {
            get => _maxFigures;
            set => _maxFigures = Mathf.Clamp(value, 1, 64);
        }

        /// <summary>Gets or sets where figures are put. Affects figures created later.</summary>
        public FigurePlacement Placement
        {
            get => _placement;
            set => _placement = value;
        }

        /// <summary>Gets or sets the distance between the stages of a row or grid, in metres.</summary>
        public float Spacing
        {
            get => _spacing;
            set => _spacing = Mathf.Max(0, value);
        }

        /// <summary>Gets or sets the number of figures in each row of a grid, 1 to 16.</summary>
        public int Columns
        {
            get => _columns;
            set => _columns = Mathf.Clamp(value, 1, 16);
        }

        /// <summary>Gets or sets what a figure does while its performer's data has stopped.</summary>
        public IdlePose IdlePose
        {
            get => _idlePose;
            set => _idlePose = value;
        }

        /// <summary>Gets or sets how long a figure takes to blend to the idle pose and back, in seconds.</summary>
        public float BlendSeconds
        {
            get => _blendSeconds;
            set => _blendSeconds = Mathf.Max(0, value);
        }

        /// <summary>Gets or sets after how many seconds idle figures are destroyed. 0 for never.</summary>
        public float DespawnSeconds
        {
            get => _despawnSeconds;
            set => _despawnSeconds = Mathf.Max(0, value);
        }

        /// <summary>Gets the figures, in the order in which they were created.</summary>
        public IReadOnlyList<SpawnedFigure> Figures => _figures;

        /// <summary>Gets the reason why a performer has no figure, and the setting to change. Empty if there is no problem.</summary>
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
                Show(_source);
            else
                ReportNoSource();

            // Handlers may disable the spawner, which empties the list.
            for (int i = _figures.Count - 1; i >= 0; i--)
            {
                if (i < _figures.Count)
                    Watch(_figures[i]);
            }
        }

        private void OnDisable() => DespawnAll();

        // The drivers of figures keep the source that they were created for.
        private void Show(MocapSource source)
        {
            if (!ReferenceEquals(source, _shownSource))
                DespawnAll();

            // A handler may have set another source.
            _shownSource = source;
            if (string.Equals(Problem, NoSource, StringComparison.Ordinal))
                Problem = "";

            if (_source == source)
                SpawnMissing(source.Performers);
        }

        // What was wrong with the performers of a source is found again with the next source.
        private void ReportNoSource() => (Problem, _isFull, _badPrefab) = (NoSource, false, null);

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
            // Does not repeat the check in every frame.
            if (_prefab != null && _prefab == _badPrefab)
                return;

            int place = FindPlace();
            GameObject? root = _prefab == null ? CreateBuilt(performer, _material) : CreateFromPrefab(_prefab);
            if (root == null)
                return;

            FigureDriver driver = root.GetComponentInChildren<FigureDriver>(true);
            driver.Assign(_source, performer);
            root.name = $"{performer.Name} ({performer.AvatarIndex})";
            root.transform.SetParent(transform, false);
            root.transform.localPosition = GetPosition(place);
            root.SetActive(true);

            if (!_isFull)
                Problem = "";

            var figure = new SpawnedFigure(root, driver, performer, place);
            _figures.Add(figure);
            Handlers.Raise(Spawned, figure, this);
            Handlers.Raise(_onSpawned, root, this);
        }

        // Inactive until everything is set. Otherwise the driver would look for a source of its own.
        private static GameObject CreateBuilt(Performer performer, Material? material)
        {
            var root = new GameObject();
            root.SetActive(false);
            root.AddComponent<HumanoidDriver>();
            FigureBuilder builder = root.AddComponent<FigureBuilder>();
            builder.Look = FigureLook.Numbered(performer.AvatarIndex);
            builder.Look.Material = material;
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

            Problem = $"The prefab \"{prefab.name}\" has neither a driver nor an Animator with a Humanoid avatar. In the model's import settings, tab Rig, set Animation Type to Humanoid.";
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

            if (figure.Update(figure.Performer.IsLive && IsPresent(figure.Performer), _idlePose, _blendSeconds, FrameTime.Delta))
                Handlers.Raise(IdleChanged, figure, this);

            if (_despawnSeconds > 0 && figure.IdleSeconds >= _despawnSeconds)
                Despawn(figure);
        }

        private void Despawn(SpawnedFigure figure)
        {
            if (!_figures.Remove(figure) || figure.IsDestroyed)
                return;

            Handlers.Raise(Despawning, figure, this);
            Handlers.Raise(_onDespawning, figure.Root, this);
            Disposal.Destroy(figure.Root);
        }

        // A performer that left its source is no longer updated.
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

        // The first free place, so that no figure moves when a performer leaves.
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
