using NeuronMocap.Bvh;

namespace NeuronMocap.Tests.Bvh;

/// <summary>
/// The world transforms of the joints of a row: matrices in double precision, computed from the channels without code of the library. A position
/// channel replaces its coordinate of the OFFSET.
/// </summary>
internal sealed class RawPose
{
    private readonly Dictionary<string, double[,]> _transforms = new(StringComparer.Ordinal);
    private readonly Dictionary<string, double[]> _ends = new(StringComparer.Ordinal);

    public RawPose(BvhDocument document, int frame)
    {
        float[] row = document.GetValues(frame).ToArray();
        var worlds = new Dictionary<BvhJoint, double[,]>();
        foreach (BvhJoint joint in document.Joints)
        {
            double[,] local = Local(joint, row);
            double[,] world = joint.Parent is null ? local : Product(worlds[joint.Parent], local);
            worlds[joint] = world;
            _transforms[joint.Name] = world;
            if (joint.EndSite is { } end)
                _ends[joint.Name] = Place(Product(world, Moved([end.X, end.Y, end.Z])));
        }
    }

    public IReadOnlyCollection<string> Names => _transforms.Keys;

    public double[] Position(string joint) => Place(_transforms[joint]);

    public double[] End(string joint) => _ends[joint];

    /// <summary>
    /// Returns the largest differences between the joints of two poses, in position and in entries of the rotation. Joint names may differ.
    /// </summary>
    public (double Position, double Rotation) Distance(RawPose other, Func<string, string>? rename = null)
    {
        double position = 0;
        double rotation = 0;
        foreach ((string name, double[,] mine) in _transforms)
        {
            string otherName = rename?.Invoke(name) ?? name;
            double[,] theirs = other._transforms[otherName];
            for (int row = 0; row < 3; row++)
            {
                position = Math.Max(position, Math.Abs(mine[row, 3] - theirs[row, 3]));
                for (int column = 0; column < 3; column++)
                    rotation = Math.Max(rotation, Math.Abs(mine[row, column] - theirs[row, column]));
            }

            if (_ends.TryGetValue(name, out double[]? end))
                position = Math.Max(position, end.Zip(other._ends[otherName], (a, b) => Math.Abs(a - b)).Max());
        }

        return (position, rotation);
    }

    private static double[] Place(double[,] transform) => [transform[0, 3], transform[1, 3], transform[2, 3]];

    private static double[,] Local(BvhJoint joint, float[] row)
    {
        double[] place = [joint.Offset.X, joint.Offset.Y, joint.Offset.Z];
        double[,] rotation = Moved([0, 0, 0]);
        for (int i = 0; i < joint.Channels.Count; i++)
        {
            string channel = joint.Channels[i].ToString();
            double value = row[joint.FirstChannel + i];
            if (channel.EndsWith("position", StringComparison.Ordinal))
                place[channel[0] - 'X'] = value;
            else if (channel.EndsWith("rotation", StringComparison.Ordinal))
                rotation = Product(rotation, Turned(channel[0], value * Math.PI / 180));
        }

        return Product(Moved(place), rotation);
    }

    private static double[,] Moved(double[] place) => new[,]
    {
        { 1, 0, 0, place[0] },
        { 0, 1, 0, place[1] },
        { 0, 0, 1, place[2] },
        { 0, 0, 0, 1.0 },
    };

    private static double[,] Turned(char axis, double angle)
    {
        (double sine, double cosine) = Math.SinCos(angle);
        return axis switch
        {
            'X' => new[,] { { 1, 0, 0, 0 }, { 0, cosine, -sine, 0 }, { 0, sine, cosine, 0 }, { 0, 0, 0, 1 } },
            'Y' => new[,] { { cosine, 0, sine, 0 }, { 0, 1, 0, 0 }, { -sine, 0, cosine, 0 }, { 0, 0, 0, 1 } },
            _ => new[,] { { cosine, -sine, 0, 0 }, { sine, cosine, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 } },
        };
    }

    private static double[,] Product(double[,] a, double[,] b)
    {
        double[,] product = new double[4, 4];
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
            {
                for (int i = 0; i < 4; i++)
                    product[row, column] += a[row, i] * b[i, column];
            }
        }

        return product;
    }
}
