#nullable enable

using System.Collections.Generic;
using NeuronMocap.Retargeting;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The settings of a vendor's component in the words of this package, and notes about those that differ.
    internal sealed class VendorSettings
    {
        // The vendor raises the hips by this much by default, because it does not scale root motion.
        private const float UsualHeightOffset = 0.035f;

        // The fields that are read. A prefab instance may change them.
        public static readonly IReadOnlyCollection<string> FieldNames = new[]
        {
            "address", "port", "socketType", "actorID", "useNewRig", "connectToAxis", "enableHipsMovement", "hipHeightOffset", "boundAnimator", "root", "prefix",
        };

        private readonly VendorComponent _component;
        private readonly List<string> _notes = new List<string>();

        public VendorSettings(VendorComponent component)
        {
            _component = component;
            IVendorFields fields = component.Fields;
            SkeletonVariantSetting variant = fields.FindNumber("useNewRig") switch
            {
                null => SkeletonVariantSetting.Auto,
                0 => SkeletonVariantSetting.Spine3,
                _ => SkeletonVariantSetting.Neck1,
            };
            TransportKind transport = fields.FindNumber("socketType") == 1 ? TransportKind.Udp : TransportKind.Tcp;
            Source = new SourceAddress((fields.FindText("address") ?? "127.0.0.1").Trim(), (int)(fields.FindNumber("port") ?? 7001), transport, variant);
            Performer = (int)(fields.FindNumber("actorID") ?? 0);
            IsEnabled = component.IsEnabled && fields.FindNumber("connectToAxis") != 0;
            RootMotion = fields.FindNumber("enableHipsMovement") == 0 ? RootMotion.InPlace : RootMotion.Full;
            HeightOffset = fields.FindNumber("hipHeightOffset") is { } offset ? Mathf.Clamp(offset - UsualHeightOffset, -1, 1) : 0;
            AddNotes(fields);
        }

        public SourceAddress Source { get; }

        public int Performer { get; }

        public bool IsEnabled { get; }

        public RootMotion RootMotion { get; }

        public float HeightOffset { get; }

        // What is different afterwards.
        public IReadOnlyList<string> Notes => _notes;

        // Why they cannot be taken over. Empty if they can.
        public string FindObstacle()
        {
            if (Source.Port < 1 || Source.Port > 65535)
                return $"Its port is {Source.Port}. A port is 1 to 65535.";

            return Performer < 0 ? $"Its actor ID is {Performer}. Performers count from 0." : string.Empty;
        }

        public void CopyTo(FigureDriver driver)
        {
            driver.PerformerIndex = Performer;
            driver.RootMotion = RootMotion;
            driver.HeightOffset = HeightOffset;
            driver.enabled = IsEnabled;
            IVendorFields fields = _component.Fields;
            if (driver is HumanoidDriver humanoid)
            {
                humanoid.Animator = fields.FindObject<Animator>("boundAnimator");
            }
            else if (driver is GenericRigDriver generic)
            {
                generic.Root = fields.FindObject<Transform>("root");
                generic.Prefix = fields.FindText("prefix") ?? string.Empty;
            }
        }

        private void AddNotes(IVendorFields fields)
        {
            if (fields.FindNumber("connectToAxis") == 0)
                _notes.Add("Connect To Axis was off, so the driver is disabled.");
            if (RootMotion == RootMotion.InPlace)
                _notes.Add("Enable Hips Movement was off, so Root Motion is In Place. The hips still turn, and move up and down. To keep them still, as older versions of the vendor's scripts did, set Hips of Part Weights to 0.");
            if (Mathf.Abs(HeightOffset) > 1e-4f)
                _notes.Add($"Hip Height Offset was not the vendor's usual {UsualHeightOffset} m, so Height Offset is the difference.");
            if (fields.FindNumber("physicalUpdate") > 0 || fields.FindNumber("motionUpdateMethod") > 0)
                _notes.Add("Physical updates are not taken over. For them, set Drive Time to Physics, and choose Add Colliders.");
        }
    }
}
