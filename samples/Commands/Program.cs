// Asks a server what its stream does not carry: rotation order, bone sizes and BVH header; then zeroes an avatar out.
//
//   dotnet run --project samples/Commands                           a simulator inside this program
//   dotnet run --project samples/Commands -- 192.168.1.20           a computer that runs Axis Studio; also HOST:PORT, port 8013 unless given
//
// In a project of your own: dotnet add package NeuronMocap (and NeuronMocap.Server for the simulator).
// Exit code: 0 every command was answered, 1 one was not, 2 wrong arguments.
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

// Connects with the first command, and again with the next one when the connection was lost.
await using var commands = new NeuronCommandClient(options);
try
{
    RotationOrder order = await commands.GetRotationOrderAsync();
    Console.WriteLine($"Rotation order: {order}");

    BoneDimensions body = await commands.GetBoneDimensionsAsync(avatarIndex: 0);
    Console.WriteLine($"Upper arm {body.UpperArm:0.000} m, forearm {body.Forearm:0.000} m, upper leg {body.UpperLeg:0.000} m, lower leg {body.LowerLeg:0.000} m");

    // The offsets of every bone are what a skeleton of this performer's size is made of.
    BvhDocument header = await commands.GetBvhHeaderAsync(avatarIndex: 0);
    BvhJoint hips = header.Joints[0];
    Console.WriteLine($"BVH header: {header.Joints.Count} joints, the first is {hips.Name} with {hips.Channels.Count} channels");

    // The performer stands in the T-pose for this. It turns the avatar so that it looks ahead.
    await commands.ZeroOutAsync(avatarIndex: 0);
    Console.WriteLine("Zeroed out.");
}
catch (NeuronCommandException exception)
{
    // The reason is for the program, the message for a person.
    Console.Error.WriteLine($"{exception.Reason}: {exception.Message}");
    return 1;
}

// A command that fails says so, and the client goes on.
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
