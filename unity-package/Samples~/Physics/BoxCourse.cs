#nullable enable
using System;
using System.Collections.Generic;
using NeuronMocap.Retargeting;
using UnityEngine;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>
    /// Boxes on the path of a figure that knocks them over, and a bat in its hand. The figure gets colliders. Its driver works in physics steps, so
    /// what it touches is pushed with the right speed.
    /// </summary>
    public sealed class BoxCourse : MonoBehaviour
    {
        // The simulated performer walks round a ring with this radius, in metres.
        private const float Radius = 1;
        private const int Places = 12;

        private static readonly Vector3 BoxSize = new Vector3(0.2f, 0.5f, 0.2f);

        // A cylinder is 2 m long and 1 m wide.
        private static readonly Vector3 BatSize = new Vector3(0.05f, 0.35f, 0.05f);

        // Components of cubes and cylinders. Player builds strip classes that no script names, and CreatePrimitive needs these.
        private static readonly Type[] PrimitiveParts = { typeof(MeshFilter), typeof(MeshRenderer), typeof(BoxCollider), typeof(CapsuleCollider) };

        [SerializeField]
        [Tooltip("Builds the figure. Its driver has Drive Time at Physics.")]
        private FigureBuilder? _builder;

        private readonly List<Renderer> _shapes = new List<Renderer>();
        private readonly List<Rigidbody> _boxes = new List<Rigidbody>();

        /// <summary>Gets or sets the builder of the figure. Set it before the component is enabled.</summary>
        public FigureBuilder? Builder
        {
            get => _builder;
            set => _builder = value;
        }

        /// <summary>Gets the boxes.</summary>
        public IReadOnlyList<Rigidbody> Boxes => _boxes;

        /// <summary>Gets the bat, or null before there is a figure.</summary>
        public HandProp? Bat { get; private set; }

        /// <summary>Puts all boxes back on the path.</summary>
        [ContextMenu("Put Back")]
        public void PutBack()
        {
            for (int i = 0; i < _boxes.Count; i++)
            {
                // The performer starts at the first place.
                float angle = (i + 1) * 2 * Mathf.PI / Places;

                // A kinematic body has no speed of its own, so a box that was still falling stands still.
                _boxes[i].isKinematic = true;
                _boxes[i].transform.localPosition = new Vector3(Radius * Mathf.Cos(angle), BoxSize.y / 2, Radius * Mathf.Sin(angle));
                _boxes[i].transform.localRotation = Quaternion.identity;
                _boxes[i].isKinematic = false;
            }
        }

        private void OnEnable()
        {
            if (_builder != null)
                _builder.Built += Equip;
        }

        private void Start()
        {
            for (int i = 1; i < Places; i++)
                _boxes.Add(Add(PrimitiveType.Cube, "Box", BoxSize));

            PutBack();
        }

        private void OnDisable()
        {
            if (_builder != null)
                _builder.Built -= Equip;
        }

        // Clicks on the button below need the old Input Manager.
        private void Update()
        {
            if (KeyPresses.IsPressed(KeyCode.P))
                PutBack();
        }

        private void OnGUI()
        {
            GUILayout.BeginArea(new Rect(10, 10, 180, 40));
            if (GUILayout.Button("Put boxes back (key P)"))
                PutBack();

            GUILayout.EndArea();
        }

        // A figure is built again when the sizes of its performer change.
        private void Equip(HumanoidFigure figure)
        {
            FigureColliders.Add(_builder!.Driver);
            if (Bat == null)
                Bat = AddBat(_builder.Driver);

            // The materials of the figure fit the render pipeline. They are destroyed with the figure.
            foreach (Renderer shape in _shapes)
                shape.sharedMaterial = figure.Renderer.sharedMaterials[1];
        }

        private HandProp AddBat(FigureDriver driver)
        {
            Rigidbody body = Add(PrimitiveType.Cylinder, "Bat", BatSize);
            body.isKinematic = true;
            HandProp bat = body.gameObject.AddComponent<HandProp>();
            bat.Driver = driver;
            bat.Bone = HumanoidBone.RightHand;

            // In the T-pose, the right hand points to +X and the fist closes around +Z.
            bat.PositionOffset = new Vector3(0.08f, -0.03f, 0.25f);
            bat.RotationOffset = new Vector3(90, 0, 0);
            return bat;
        }

        private Rigidbody Add(PrimitiveType type, string label, Vector3 size)
        {
            GameObject shape = GameObject.CreatePrimitive(type);
            shape.name = label;
            shape.transform.SetParent(transform, false);
            shape.transform.localScale = size;
            Renderer surface = shape.GetComponent<Renderer>();
            if (_builder != null && _builder.Figure is { IsDestroyed: false } figure)
                surface.sharedMaterial = figure.Renderer.sharedMaterials[1];

            _shapes.Add(surface);
            return shape.AddComponent<Rigidbody>();
        }
    }
}
