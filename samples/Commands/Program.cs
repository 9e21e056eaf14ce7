// Asks a server for information that its stream lacks: rotation order, bone sizes and BVH header. Then zeroes out an avatar.
//
//   dotnet run --project samples/Commands                           a simulator inside this program
//   dotnet run --project samples/Commands -- 192.168.1.20           a computer that runs Axis Studio; also HOST:PORT, default port 8013
//
// In your own project: dotnet add package NeuronMocap (and NeuronMocap.Server for the simulator).
// Exit code: 0 every command was answered, 1 a command failed, 2 wrong arguments.
using NeuronMocap;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

using Broadcaster? demo = args.Length == 0 ? Broadcaster.StartDemo() : null;
using CommandServer? demoCommands = demo is null ? null : new CommandServer(demo, new CommandServerOptions { Port = 0 });
demoCommands?.Start();

NeuronCommandOptions options;
try
{
    options = NeuronCommandOptions.Parse(args is [var address, ..] ? address : $"{demoCommands?.LocalEndPoint}");
}
catch (FormatException exception)
{
    Console.Error.WriteLine(exception.Message);
    return 2;
}

// Connects with the first command. If the connection is lost, it reconnects with the next command.
await using var commands = new NeuronCommandClient(options);
try
{
    RotationOrder order = await commands.GetRotationOrderAsync();
    Console.WriteLine($"Rotation order: {order}");

    BoneDimensions body = await commands.GetBoneDimensionsAsync(avatarIndex: 0);
    Console.WriteLine($"Upper arm {body.UpperArm:0.000} m, forearm {body.Forearm:0.000} m, upper leg {body.UpperLeg:0.000} m, lower leg {body.LowerLeg:0.000} m");

    // The header holds the offset of every bone. You can build a skeleton of this performer's size from it.
    BvhDocument header = await commands.GetBvhHeaderAsync(avatarIndex: 0);
    BvhJoint hips = header.Joints[0];
    Console.WriteLine($"BVH header: {header.Joints.Count} joints, the first is {hips.Name} with {hips.Channels.Count} channels");

    // For this command the performer stands in the T-pose. It turns the avatar to face front.
    await commands.ZeroOutAsync(avatarIndex: 0);
    Console.WriteLine("Zeroed out.");
}
catch (NeuronCommandException exception)
{
    // The reason is for the program, the message for the user.
    Console.Error.WriteLine($"{exception.Reason}: {exception.Message}");
    return 1;
}

// A command that fails throws, and the client remains usable.
try
{
    await commands.GetBoneDimensionsAsync(avatarIndex: 99);
    Console.WriteLine("There is an avatar 99.");
}
catch (NeuronCommandException exception)
{
    Console.WriteLine($"Avatar 99, {exception.Reason}: {exception.Message}");
}

return 0;
