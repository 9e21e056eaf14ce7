using System;
using System.Drawing;
using System.Drawing.Drawing2D;
using System.Linq;
using System.Numerics;
using System.Windows.Forms;
using NeuronMocap;
using NeuronMocap.Skeleton;

/// <summary>Draws the newest pose from the front and from the side, in grey while it is disabled.</summary>
internal sealed class SkeletonView : Control
{
    // Centimetres.
    private const float VisibleWidth = 160, VisibleHeight = 220, BelowGround = 20, MarkDistance = 50, Farthest = 100_000;

    private readonly BoneTransform[] _world = new BoneTransform[BoneHierarchy.BoneCount];
    private readonly Vector3[] _joints = new Vector3[JointPositions.Count];
    private (int From, int To, Color Color, float Width)[] _lines = [];

    public SkeletonView() => (DoubleBuffered, ResizeRedraw, TabStop, Text) = (true, true, false, "Skeleton");

    /// <summary>Keeps the pose, because the frame is reused after the handler. Windows paints when all waiting frames are handled.</summary>
    public void ShowPose(MotionFrame frame)
    {
        if (!frame.HasSkeleton)
            return;

        SkeletonBody body = SkeletonBody.GetDefault(frame.Format.Variant);
        frame.CopyWorldTransforms(_world, body);
        JointPositions.Copy(_world, body, _joints);
        bool isDrawable = Array.TrueForAll(_joints, static joint => joint.Length() < Farthest); // a stream can contain any number
        _lines = !isDrawable ? [] : _lines.Length > 0 ? _lines : CreateLines(body.Variant);
        Invalidate();
    }

    protected override void OnPaint(PaintEventArgs e)
    {
        base.OnPaint(e);
        e.Graphics.SmoothingMode = SmoothingMode.AntiAlias;
        int half = Width / 2;
        DrawView(e.Graphics, "Front", new Rectangle(0, 0, half, Height), _joints);
        Vector3[] turned = Array.ConvertAll(_joints, static joint => new Vector3(joint.Z, joint.Y, -joint.X));
        DrawView(e.Graphics, "Side", new Rectangle(half, 0, Width - half, Height), turned);
    }

    // Looks along -Z. The hips stay in the middle, and the marks on the ground pass by.
    private void DrawView(Graphics graphics, string title, Rectangle bounds, Vector3[] joints)
    {
        float scale = Math.Min(bounds.Width / VisibleWidth, bounds.Height / VisibleHeight);
        float ground = bounds.Bottom - (BelowGround * scale);
        float left = joints[0].X - (bounds.Width / 2f / scale);
        PointF Project(Vector3 point) => new(bounds.X + ((point.X - left) * scale), ground - (point.Y * scale));

        graphics.SetClip(bounds);
        TextRenderer.DrawText(graphics, title, Font, new Point(bounds.X + (Font.Height / 2), Font.Height / 2), Color.Gray);
        if (_lines.Length == 0)
            return;

        using var pen = new Pen(Color.DimGray);
        graphics.DrawLine(pen, bounds.Left, ground, bounds.Right, ground);
        for (float mark = MarkDistance * (float)Math.Ceiling(left / MarkDistance); mark < left + (bounds.Width / scale); mark += MarkDistance)
            graphics.DrawLine(pen, Project(new Vector3(mark, 0, 0)), Project(new Vector3(mark, -4, 0)));

        // The nearest bones are drawn last.
        (pen.StartCap, pen.EndCap) = (LineCap.Round, LineCap.Round);
        foreach (var line in _lines.OrderBy(line => joints[line.From].Z + joints[line.To].Z))
        {
            pen.Color = Enabled ? line.Color : Color.DimGray;
            pen.Width = line.Width * scale;
            graphics.DrawLine(pen, Project(joints[line.From]), Project(joints[line.To]));
        }
    }

    // A line from each parent to its bone, and one to each end of the body: head, fingertips and toes.
    private static (int From, int To, Color Color, float Width)[] CreateLines(SkeletonVariant variant)
    {
        var bones = BoneHierarchy.Bones.ToArray().Skip(1).Select(bone => (Parent: BoneHierarchy.GetParent(bone, variant)!.Value, Joint: (int)bone));
        var ends = JointPositions.EndSiteBones.ToArray().Select(bone => (Parent: bone, Joint: JointPositions.GetEndSiteIndex(bone)));
        return [.. bones.Concat(ends).Select(line => ((int)line.Parent, line.Joint, ColorOf($"{line.Parent}"), WidthOf($"{line.Parent}")))];
    }

    private static Color ColorOf(string bone) => bone.StartsWith("Left", StringComparison.Ordinal) ? Color.DodgerBlue
        : bone.StartsWith("Right", StringComparison.Ordinal) ? Color.Orange : Color.WhiteSmoke;

    private static float WidthOf(string bone) => bone.Contains("Hand") ? 1.5f : bone is "Head" ? 15 : 5;
}
