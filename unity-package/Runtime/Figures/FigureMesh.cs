#nullable enable
using System;
using NeuronMocap.Figures;
using UnityEngine;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // The library's surface as a mesh with two submeshes, one for each colour. Each vertex follows one bone, so joints look like those of a doll.
    internal static class FigureMesh
    {
        public static Mesh Create(FigureSurface surface)
        {
            var mesh = new Mesh
            {
                name = "Neuron figure",
                vertices = Mirror(surface.Positions),
                normals = Mirror(surface.Normals),
                boneWeights = GetWeights(surface.Bones),
                bindposes = GetBindPoses(surface.Joints),
                subMeshCount = 2,
            };
            mesh.SetTriangles(Reverse(surface.BodyTriangles), 0);
            mesh.SetTriangles(Reverse(surface.AccentTriangles), 1);
            mesh.RecalculateBounds();
            return mesh;
        }

        // To Unity's axes. The unit is the metre in both.
        private static Vector3[] Mirror(ReadOnlySpan<System.Numerics.Vector3> vectors)
        {
            var mirrored = new Vector3[vectors.Length];
            for (int i = 0; i < mirrored.Length; i++)
                mirrored[i] = new Vector3(-vectors[i].X, vectors[i].Y, vectors[i].Z);

            return mirrored;
        }

        // Mirroring turns triangles inside out.
        private static int[] Reverse(ReadOnlySpan<int> corners)
        {
            int[] reversed = corners.ToArray();
            for (int i = 0; i < reversed.Length; i += 3)
                (reversed[i + 1], reversed[i + 2]) = (reversed[i + 2], reversed[i + 1]);

            return reversed;
        }

        private static BoneWeight[] GetWeights(ReadOnlySpan<Bone> bones)
        {
            var weights = new BoneWeight[bones.Length];
            for (int i = 0; i < weights.Length; i++)
                weights[i] = new BoneWeight { boneIndex0 = (int)bones[i], weight0 = 1 };

            return weights;
        }

        private static Matrix4x4[] GetBindPoses(ReadOnlySpan<System.Numerics.Vector3> joints)
        {
            Vector3[] positions = Mirror(joints);
            var poses = new Matrix4x4[positions.Length];
            for (int i = 0; i < poses.Length; i++)
                poses[i] = Matrix4x4.Translate(-positions[i]);

            return poses;
        }
    }
}
