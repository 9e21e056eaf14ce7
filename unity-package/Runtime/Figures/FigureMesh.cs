#nullable enable
using System.Collections.Generic;
using UnityEngine;
using Vector2 = UnityEngine.Vector2;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // All shapes of a figure in one mesh with two submeshes, one for each colour. Each vertex follows one bone, so joints look like those of a doll.
    internal sealed class FigureMesh
    {
        private const int RingsPerCap = 5;
        private const int RingsPerMuscle = 6;
        private const float ThinShape = 0.02f;

        private readonly List<Vector3> _vertices = new List<Vector3>(8192);
        private readonly List<BoneWeight> _weights = new List<BoneWeight>(8192);
        private readonly List<int> _body = new List<int>(32768);
        private readonly List<int> _accent = new List<int>(16384);

        private FigureMesh()
        {
        }

        // joints: rest positions of the bones in the axes of the figure's root, in metres.
        public static Mesh Create(IReadOnlyList<FigureShape> shapes, IReadOnlyList<Vector3> joints)
        {
            var mesh = new FigureMesh();
            foreach (FigureShape shape in shapes)
                mesh.Add(shape, joints[(int)shape.Bone]);

            return mesh.ToMesh(joints);
        }

        private Mesh ToMesh(IReadOnlyList<Vector3> joints)
        {
            var bindPoses = new Matrix4x4[joints.Count];
            for (int i = 0; i < bindPoses.Length; i++)
                bindPoses[i] = Matrix4x4.Translate(-joints[i]);

            var mesh = new Mesh { name = "Neuron figure" };
            mesh.SetVertices(_vertices);
            mesh.boneWeights = _weights.ToArray();
            mesh.bindposes = bindPoses;
            mesh.subMeshCount = 2;
            mesh.SetTriangles(_body, 0);
            mesh.SetTriangles(_accent, 1);
            mesh.RecalculateNormals();
            mesh.RecalculateBounds();
            return mesh;
        }

        private void Add(in FigureShape shape, Vector3 joint)
        {
            Vector3 axis = shape.End - shape.Start;
            axis = axis.sqrMagnitude > 1e-10f ? axis.normalized : Vector3.up;
            Vector3 side = Vector3.ProjectOnPlane(shape.Side, axis);
            side = side.sqrMagnitude > 1e-6f ? side.normalized : Vector3.Cross(axis, Vector3.right).normalized;
            Vector3 across = Vector3.Cross(axis, side);
            int segments = Mathf.Max(shape.StartRadii.x, shape.EndRadii.x) < ThinShape ? 10 : 20;
            List<int> triangles = shape.IsAccent ? _accent : _body;

            int first = _vertices.Count;
            float startCap = Cap(shape.StartRadii);
            float endCap = Cap(shape.EndRadii);
            _vertices.Add(joint + shape.Start - (axis * startCap));
            for (int ring = 1; ring <= RingsPerCap; ring++)
                AddRing(joint + shape.Start, (float)ring / RingsPerCap, shape.StartRadii, -startCap);

            int muscleRings = shape.Bulge > 0 ? RingsPerMuscle : 0;
            for (int ring = 1; ring <= muscleRings; ring++)
            {
                float along = (float)ring / (muscleRings + 1);
                float thickness = 1 + (shape.Bulge * Mathf.Sin(Mathf.PI * Mathf.Sqrt(along)));
                AddRing(joint + Vector3.Lerp(shape.Start, shape.End, along), 1, Vector2.Lerp(shape.StartRadii, shape.EndRadii, along) * thickness, 0);
            }

            for (int ring = RingsPerCap; ring >= 1; ring--)
                AddRing(joint + shape.End, (float)ring / RingsPerCap, shape.EndRadii, endCap);

            _vertices.Add(joint + shape.End + (axis * endCap));
            AddTriangles(triangles, first, segments, (2 * RingsPerCap) + muscleRings);

            var weight = new BoneWeight { boneIndex0 = (int)shape.Bone, weight0 = 1 };
            while (_weights.Count < _vertices.Count)
                _weights.Add(weight);

            // From the pole (0) to the full section (1).
            void AddRing(Vector3 centre, float latitude, Vector2 radii, float cap)
            {
                float angle = latitude * Mathf.PI / 2;
                centre += axis * (cap * Mathf.Cos(angle));
                for (int i = 0; i < segments; i++)
                {
                    float turn = 2 * Mathf.PI * i / segments;
                    Vector3 spoke = (side * (radii.x * Mathf.Cos(turn))) + (across * (radii.y * Mathf.Sin(turn)));
                    _vertices.Add(centre + (spoke * Mathf.Sin(angle)));
                }
            }
        }

        // A pole, rings, a pole. Unity shows the side on which a triangle's corners are clockwise.
        private static void AddTriangles(List<int> triangles, int first, int segments, int rings)
        {
            int last = first + 1 + (rings * segments);
            for (int i = 0; i < segments; i++)
            {
                int next = (i + 1) % segments;
                AddTriangle(triangles, first, first + 1 + next, first + 1 + i);
                for (int ring = 0; ring < rings - 1; ring++)
                {
                    int low = first + 1 + (ring * segments);
                    int high = low + segments;
                    AddTriangle(triangles, low + i, low + next, high + i);
                    AddTriangle(triangles, low + next, high + next, high + i);
                }

                AddTriangle(triangles, last, last - segments + i, last - segments + next);
            }
        }

        private static void AddTriangle(List<int> triangles, int a, int b, int c)
        {
            triangles.Add(a);
            triangles.Add(b);
            triangles.Add(c);
        }

        private static float Cap(Vector2 radii) => Mathf.Min(radii.x, radii.y);
    }
}
