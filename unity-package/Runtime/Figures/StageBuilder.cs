#nullable enable

using System;
using UnityEngine;
using Quaternion = UnityEngine.Quaternion;
using Vector2 = UnityEngine.Vector2;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Builds a stage for scenes that have none: a ground with lines a metre apart, a light, and a camera that looks at a target. The stage exists
    /// while this component is enabled.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Stage Builder")]
    [HelpURL(HelpPage.Components + "#stage-builder")]
    [DefaultExecutionOrder(300)]
    [DisallowMultipleComponent]
    public sealed class StageBuilder : MonoBehaviour
    {
        // Width of a primitive plane, in metres.
        private const float PlaneSize = 10;
        private const int TextureSize = 128;
        private const int LineWidth = 2;

        // Components of a primitive plane. Player builds strip classes that no script names, and CreatePrimitive needs these.
        private static readonly Type[] PlaneParts = { typeof(MeshFilter), typeof(MeshRenderer), typeof(MeshCollider) };

        [SerializeField]
        [Tooltip("A ground with lines a metre apart.")]
        private bool _ground = true;

        [SerializeField]
        [Range(2, 100)]
        [Tooltip("Width of the ground, in metres.")]
        private float _groundSize = 20;

        [SerializeField]
        [Tooltip("Colour of the ground.")]
        private Color _groundColor = new Color(0.32f, 0.34f, 0.38f);

        [SerializeField]
        [Tooltip("A material to copy and colour. Empty: the lit material of the render pipeline, which builds of the scene include.")]
        private Material? _groundMaterial;

        [SerializeField]
        [Tooltip("Add a directional light.")]
        private bool _light = true;

        [SerializeField]
        [Tooltip("Add a camera if the scene has no main camera.")]
        private bool _camera = true;

        [SerializeField]
        [Tooltip("The figure that the camera looks at and follows: see Follow Camera. Empty: the camera looks at a point 1 m above this object.")]
        private Transform? _target;

        [SerializeField]
        [Tooltip("Position of the camera relative to the target, in metres.")]
        private Vector3 _viewpoint = new Vector3(1.2f, 0.6f, 3.4f);

        private GameObject? _stage;
        private FollowCamera? _follow;

        /// <summary>
        /// Gets or sets the figure that the camera looks at and follows: see <see cref="FollowCamera.Target"/>. Null: the camera looks at a point 1 m
        /// above this object.
        /// </summary>
        public Transform? Target
        {
            get => _target;
            set => _target = value;
        }

        /// <summary>Gets or sets the position of the camera relative to the target, in metres.</summary>
        public Vector3 Viewpoint
        {
            get => _viewpoint;
            set => _viewpoint = value;
        }

        /// <summary>
        /// Gets or sets a material to copy and colour for the ground. Null: the lit material of the render pipeline. Applies when the component is
        /// next enabled.
        /// </summary>
        public Material? GroundMaterial
        {
            get => _groundMaterial;
            set => _groundMaterial = value;
        }

        /// <summary>Gets or sets whether the stage has a ground. Applies when the component is next enabled.</summary>
        public bool HasGround
        {
            get => _ground;
            set => _ground = value;
        }

        /// <summary>Gets or sets whether the stage has a light. Applies when the component is next enabled.</summary>
        public bool HasLight
        {
            get => _light;
            set => _light = value;
        }

        /// <summary>
        /// Gets or sets whether the stage has a camera if the scene has no main camera. Applies when the component is next enabled.
        /// </summary>
        public bool HasCamera
        {
            get => _camera;
            set => _camera = value;
        }

        /// <summary>Gets the camera that was created, or null if the scene had one.</summary>
        public Camera? Camera { get; private set; }

        // Not in OnEnable, because Unity does not allow new children while an object is being activated.
        private void Start() => Build();

        private void Build()
        {
            if (_stage != null)
                return;

            _stage = new GameObject("Stage");
            _stage.transform.SetParent(transform, false);
            var owned = _stage.AddComponent<OwnedObjects>();
            if (_ground)
                AddGround(_stage.transform, owned);
            if (_light)
                AddLight(_stage.transform);
            if (_camera && UnityEngine.Camera.main == null)
                AddCamera(_stage.transform);
        }

        private void LateUpdate()
        {
            Build();
            if (_follow == null)
                return;

            _follow.Target = _target;
            _follow.Viewpoint = _viewpoint;
            if (_target == null)
                LookAtStage(_follow.transform);
        }

        private void OnDisable()
        {
            Disposal.Destroy(_stage);
            _stage = null;
            Camera = null;
            _follow = null;
        }

        private void LookAtStage(Transform eye)
        {
            Vector3 focus = transform.position + Vector3.up;
            eye.position = focus + _viewpoint;
            eye.LookAt(focus);
        }

        private void AddGround(Transform stage, OwnedObjects owned)
        {
            var ground = GameObject.CreatePrimitive(PrimitiveType.Plane);
            ground.name = "Ground";
            ground.transform.SetParent(stage, false);
            ground.transform.localScale = new Vector3(_groundSize / PlaneSize, 1, _groundSize / PlaneSize);
            Material material = owned.Keep(FigureMaterials.Create(_groundMaterial, _groundColor, "Ground"));
            material.mainTexture = owned.Keep(CreateGrid());
            material.mainTextureScale = new Vector2(_groundSize, _groundSize);
            ground.GetComponent<MeshRenderer>().sharedMaterial = material;
        }

        private static void AddLight(Transform stage)
        {
            var sun = new GameObject("Light");
            sun.transform.SetParent(stage, false);
            sun.transform.rotation = Quaternion.Euler(50, 200, 0);
            Light light = sun.AddComponent<Light>();
            light.type = LightType.Directional;
            light.intensity = 1.1f;
            light.shadows = LightShadows.Soft;
        }

        private void AddCamera(Transform stage)
        {
            var eye = new GameObject("Camera") { tag = "MainCamera" };
            eye.transform.SetParent(stage, false);
            Camera = eye.AddComponent<Camera>();
            Camera.nearClipPlane = 0.05f;
            Camera.fieldOfView = 45;
            _follow = eye.AddComponent<FollowCamera>();
        }

        // A square metre: white with grey edges, coloured by the material.
        private static Texture2D CreateGrid()
        {
            var pixels = new Color32[TextureSize * TextureSize];
            for (int i = 0; i < pixels.Length; i++)
            {
                int x = i % TextureSize;
                int y = i / TextureSize;
                bool isLine = x < LineWidth || y < LineWidth;
                pixels[i] = isLine ? new Color32(150, 150, 150, 255) : new Color32(255, 255, 255, 255);
            }

            var texture = new Texture2D(TextureSize, TextureSize, TextureFormat.RGBA32, true)
            {
                name = "Metres",
                wrapMode = TextureWrapMode.Repeat,
                anisoLevel = 8,
            };
            texture.SetPixels32(pixels);
            texture.Apply(true, true);
            return texture;
        }
    }
}
