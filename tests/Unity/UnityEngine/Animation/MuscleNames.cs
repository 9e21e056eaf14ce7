namespace UnityEngine.StandIn;

/// <summary>The 95 muscles in Unity's order.</summary>
internal static class MuscleNames
{
    private static readonly string[] _body =
    [
        "Spine Front-Back", "Spine Left-Right", "Spine Twist Left-Right", "Chest Front-Back", "Chest Left-Right", "Chest Twist Left-Right",
        "UpperChest Front-Back", "UpperChest Left-Right", "UpperChest Twist Left-Right", "Neck Nod Down-Up", "Neck Tilt Left-Right", "Neck Turn Left-Right",
        "Head Nod Down-Up", "Head Tilt Left-Right", "Head Turn Left-Right", "Left Eye Down-Up", "Left Eye In-Out", "Right Eye Down-Up", "Right Eye In-Out",
        "Jaw Close", "Jaw Left-Right",
    ];

    private static readonly string[] _leg =
    [
        "Upper Leg Front-Back", "Upper Leg In-Out", "Upper Leg Twist In-Out", "Lower Leg Stretch", "Lower Leg Twist In-Out", "Foot Up-Down", "Foot Twist In-Out", "Toes Up-Down",
    ];

    private static readonly string[] _arm =
    [
        "Shoulder Down-Up", "Shoulder Front-Back", "Arm Down-Up", "Arm Front-Back", "Arm Twist In-Out", "Forearm Stretch", "Forearm Twist In-Out", "Hand Down-Up", "Hand In-Out",
    ];

    private static readonly string[] _fingers = ["Thumb", "Index", "Middle", "Ring", "Little"];
    private static readonly string[] _finger = ["1 Stretched", "Spread", "2 Stretched", "3 Stretched"];

    public static IEnumerable<string> All =>
    [
        .. _body, .. Sided("Left", _leg), .. Sided("Right", _leg), .. Sided("Left", _arm), .. Sided("Right", _arm), .. Sided("Left", Fingers), .. Sided("Right", Fingers),
    ];

    private static IEnumerable<string> Fingers => _fingers.SelectMany(static finger => _finger.Select(move => $"{finger} {move}"));

    private static IEnumerable<string> Sided(string side, IEnumerable<string> names) => names.Select(name => $"{side} {name}");
}
