#nullable enable
using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>
    /// A game that reads joints and contacts: stand on tiles to paint them, and burst the balloon with a hand.
    /// </summary>
    public sealed class TileGame : MonoBehaviour
    {
        private const float TileSize = 0.5f;
        private const float BalloonRadius = 0.12f;

        // From the wrist to the middle of the hand, plus a margin.
        private const float Reach = 0.12f;

        // Components of cubes and spheres. Player builds strip classes that no script names, and CreatePrimitive needs these.
        private static readonly Type[] PrimitiveParts = { typeof(MeshFilter), typeof(MeshRenderer), typeof(BoxCollider), typeof(SphereCollider) };

        private static readonly Color Plain = new Color(0.3f, 0.32f, 0.36f);
        private static readonly Color Painted = new Color(0.95f, 0.42f, 0.1f);

        [SerializeField]
        [Tooltip("The source whose first performer plays.")]
        private MocapSource? _source;

        [SerializeField]
        [Range(4, 24)]
        [Tooltip("Number of tiles along each side of the floor. A tile is half a metre wide.")]
        private int _tilesPerSide = 14;

        private readonly Dictionary<Vector2Int, Renderer> _tiles = new Dictionary<Vector2Int, Renderer>();
        private readonly HashSet<Vector2Int> _painted = new HashSet<Vector2Int>();
        private MaterialPropertyBlock? _color;
        private Material? _material;
        private Transform? _balloon;

        /// <summary>Gets or sets the source whose first performer plays.</summary>
        public MocapSource? Source
        {
            get => _source;
            set => _source = value;
        }

        /// <summary>Gets the number of painted tiles.</summary>
        public int PaintedTiles => _painted.Count;

        /// <summary>Gets the number of burst balloons.</summary>
        public int Balloons { get; private set; }

        /// <summary>Gets the position of the balloon relative to this object, in metres.</summary>
        public Vector3 BalloonPosition => _balloon != null ? _balloon.localPosition : Vector3.zero;

        /// <summary>Evaluates a frame of the player: feet on tiles, hands at the balloon.</summary>
        /// <param name="performer">The player.</param>
        public void Play(Performer performer)
        {
            // Contacts say which feet touch the ground. Joints are in metres, on a stage whose origin is that of this object.
            FootContacts contacts = performer.Contacts;
            if (contacts.Left)
                Paint(performer.GetPosition(Bone.LeftFoot));
            if (contacts.Right)
                Paint(performer.GetPosition(Bone.RightFoot));

            if (_balloon != null && (IsHit(performer.GetPosition(Bone.LeftHand)) || IsHit(performer.GetPosition(Bone.RightHand))))
            {
                Balloons++;
                PlaceBalloon(performer);
            }
        }

        private void Start()
        {
            _color = new MaterialPropertyBlock();
            _material = CreateMaterial();
            for (int x = 0; x < _tilesPerSide; x++)
            {
                for (int z = 0; z < _tilesPerSide; z++)
                    AddTile(new Vector2Int(x - (_tilesPerSide / 2), z - (_tilesPerSide / 2)));
            }
        }

        private void Update()
        {
            if (_source == null || !_source.TryGetPerformer(0, out Performer? performer) || !performer.HasPose)
                return;

            if (_balloon == null)
            {
                _balloon = Add(PrimitiveType.Sphere, "Balloon", Vector3.one * (2 * BalloonRadius)).transform;
                PlaceBalloon(performer);
            }

            Play(performer);
        }

        private void OnDestroy()
        {
            if (_material != null)
                Destroy(_material);
        }

        private void OnGUI() => GUI.Label(new Rect(10, 10, 300, 40), $"{_painted.Count} of {_tiles.Count} tiles, {Balloons} balloons");

        private void AddTile(Vector2Int tile)
        {
            Renderer surface = Add(PrimitiveType.Cube, "Tile", new Vector3(TileSize * 0.96f, 0.02f, TileSize * 0.96f));
            surface.transform.localPosition = new Vector3((tile.x + 0.5f) * TileSize, -0.01f, (tile.y + 0.5f) * TileSize);
            _tiles.Add(tile, surface);
            SetColor(surface, Plain);
        }

        private Renderer Add(PrimitiveType shape, string label, Vector3 scale)
        {
            GameObject thing = GameObject.CreatePrimitive(shape);
            thing.name = label;
            Destroy(thing.GetComponent<Collider>());
            thing.transform.SetParent(transform, false);
            thing.transform.localScale = scale;
            Renderer surface = thing.GetComponent<Renderer>();
            if (_material != null)
                surface.sharedMaterial = _material;

            return surface;
        }

        // Primitives have the material of the built-in pipeline, which players with URP or HDRP do not draw. Null: it fits.
        private static Material? CreateMaterial()
        {
            RenderPipelineAsset? pipeline = GraphicsSettings.currentRenderPipeline;
            Shader? shader = pipeline != null ? pipeline.defaultShader : null;
            return shader != null ? new Material(shader) : null;
        }

        private void Paint(Vector3 foot)
        {
            var tile = new Vector2Int(Mathf.FloorToInt(foot.x / TileSize), Mathf.FloorToInt(foot.z / TileSize));
            if (_tiles.TryGetValue(tile, out Renderer? surface) && _painted.Add(tile))
                SetColor(surface, Painted);
        }

        // Both names: one for the built-in pipeline, one for URP and HDRP.
        private void SetColor(Renderer surface, Color color)
        {
            _color!.SetColor("_Color", color);
            _color.SetColor("_BaseColor", color);
            surface.SetPropertyBlock(_color);
        }

        private bool IsHit(Vector3 hand) => Vector3.Distance(hand, _balloon!.localPosition) < BalloonRadius + Reach;

        // In front of the player, to one side, between belly and head.
        private void PlaceBalloon(Performer performer)
        {
            Vector3 hips = performer.GetPosition(Bone.Hips);
            Quaternion facing = performer.GetRotation(Bone.Hips);
            var ahead = new Vector3(UnityEngine.Random.Range(-0.6f, 0.6f), UnityEngine.Random.Range(0.1f, 0.6f), UnityEngine.Random.Range(0.35f, 0.5f));
            _balloon!.localPosition = hips + (facing * ahead);
        }
    }
}
