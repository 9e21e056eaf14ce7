import com.sun.jna.Callback;
import com.sun.jna.Library;
import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.Pointer;
import com.sun.jna.Structure;
import com.sun.jna.Structure.FieldOrder;
import com.sun.jna.ptr.IntByReference;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;

/** A typical Java program: frames, status and commands through JNA. It also makes the virtual machine use its own signals. Arguments: two ports. */
public final class Reader {
    public interface NeuronDataReader extends Library {
        void BRRegisterFrameDataCallback(Pointer customedObj, FrameDataReceived handle);

        void BRRegisterCalculationDataCallback(Pointer customedObj, CalculationDataReceived handle);

        void BRRegisterSocketStatusCallback(Pointer customedObj, SocketStatusChanged handle);

        Pointer BRConnectTo(String serverIP, int nPort);

        void BRCloseSocket(Pointer sockRef);

        int BRGetSocketStatus(Pointer sockRef);

        String BRGetLastErrorMessage();

        Pointer BRConnectCmd(String serverIP, int nPort);

        // JNA reads a boolean result as an int.
        boolean ZeroOut(Pointer sockRef, int avatarIndex);

        byte ZeroOutAll(Pointer sockRef);

        boolean GetBvhRotation(Pointer sockRef, IntByReference order);

        boolean GetBoneSize(Pointer sockRef, int avatarIndex, BoneDimension dimensions);

        boolean GetBvhHeader(Pointer sockRef, int avatarIndex, byte[] data, int len);
    }

    public interface FrameDataReceived extends Callback {
        void invoke(Pointer customedObj, Pointer sender, BvhDataHeader header, Pointer data);
    }

    public interface CalculationDataReceived extends Callback {
        void invoke(Pointer customedObj, Pointer sender, CalcDataHeader header, Pointer data);
    }

    public interface SocketStatusChanged extends Callback {
        void invoke(Pointer customedObj, Pointer sender, int status, String message);
    }

    @FieldOrder({"BuildNumb", "Revision", "Minor", "Major"})
    public static class DataVersion extends Structure {
        public byte BuildNumb;
        public byte Revision;
        public byte Minor;
        public byte Major;
    }

    @FieldOrder({"Token1", "Version", "DataCount", "WithDisp", "WithReference", "AvatarIndex", "AvatarName", "FrameIndex", "Reserved", "Reserved1",
        "Reserved2", "Token2"})
    public static class BvhDataHeader extends Structure {
        public short Token1;
        public DataVersion Version;
        public short DataCount;
        public byte WithDisp;
        public byte WithReference;
        public int AvatarIndex;
        public byte[] AvatarName = new byte[32];
        public int FrameIndex;
        public int Reserved;
        public int Reserved1;
        public int Reserved2;
        public short Token2;

        public BvhDataHeader() {
            super(ALIGN_NONE);
        }

        int offsetOf(String field) {
            return fieldOffset(field);
        }
    }

    @FieldOrder({"Token1", "Version", "DataCount", "AvatarIndex", "AvatarName", "FrameIndex", "Reserved1", "Reserved2", "Reserved3", "Token2"})
    public static class CalcDataHeader extends Structure {
        public short Token1;
        public DataVersion Version;
        public int DataCount;
        public int AvatarIndex;
        public byte[] AvatarName = new byte[32];
        public int FrameIndex;
        public int Reserved1;
        public int Reserved2;
        public int Reserved3;
        public short Token2;

        public CalcDataHeader() {
            super(ALIGN_NONE);
        }
    }

    @FieldOrder({"Head", "Neck", "Body", "ShoulderWidth", "UpperArm", "Forearm", "Palm", "HipWidth", "UpperLeg", "LowerLeg", "HeelHeight", "FootLength"})
    public static class BoneDimension extends Structure {
        public float Head;
        public float Neck;
        public float Body;
        public float ShoulderWidth;
        public float UpperArm;
        public float Forearm;
        public float Palm;
        public float HipWidth;
        public float UpperLeg;
        public float LowerLeg;
        public float HeelHeight;
        public float FootLength;
    }

    private static final AtomicInteger frames = new AtomicInteger();
    private static final AtomicInteger wrong = new AtomicInteger();
    private static final CountDownLatch calculation = new CountDownLatch(1);
    private static volatile Object nothing;

    // The fields keep the callbacks alive while the library may call them: JNA frees callbacks without references.
    private static final FrameDataReceived onFrame = (object, sender, header, data) -> {
        float[] values = data.getFloatArray(0, header.DataCount & 0xFFFF);
        boolean isRight = (header.Token1 & 0xFFFF) == 0xDDFF && (header.Token2 & 0xFFFF) == 0xEEFF && header.Version.Major == 1
            && header.Version.Minor == 1 && values.length == 354 && header.WithDisp == 1 && header.FrameIndex == frames.get();
        if (frames.getAndIncrement() == 0)
            System.out.println("frame " + Pointer.nativeValue(object) + " " + isRight + " " + header.AvatarIndex + " " + Native.toString(header.AvatarName, "UTF-8"));
        if (!isRight)
            wrong.incrementAndGet();
    };

    private static final CalculationDataReceived onCalculation = (object, sender, header, data) -> {
        if (calculation.getCount() > 0)
            System.out.println("calculation " + Pointer.nativeValue(object) + " " + ((header.Token2 & 0xFFFF) == 0x99FF) + " " + header.DataCount);
        calculation.countDown();
    };

    private static final SocketStatusChanged onStatus = (object, sender, status, message) ->
        System.out.println("status " + Pointer.nativeValue(object) + " " + status + " " + message.trim());

    public static void main(String[] arguments) throws Exception {
        NeuronDataReader library = Native.load("NeuronDataReader", NeuronDataReader.class);
        BvhDataHeader header = new BvhDataHeader();
        System.out.println("sizes " + header.size() + " " + new CalcDataHeader().size() + " " + new BoneDimension().size() + " offsets "
            + header.offsetOf("DataCount") + " " + header.offsetOf("AvatarName") + " " + header.offsetOf("FrameIndex") + " " + header.offsetOf("Token2"));
        library.BRRegisterFrameDataCallback(new Pointer(1), onFrame);
        library.BRRegisterCalculationDataCallback(new Pointer(2), onCalculation);
        library.BRRegisterSocketStatusCallback(new Pointer(3), onStatus);
        System.out.println("refused " + library.BRConnectTo("127.0.0.1", 1) + " " + library.BRGetLastErrorMessage());

        int port = Integer.parseInt(arguments[0]);
        Pointer connection = library.BRConnectTo("127.0.0.1", port);
        System.out.println("connected " + (connection != null) + " " + library.BRGetSocketStatus(connection));
        System.out.println("received " + calculation.await(60, TimeUnit.SECONDS));

        Pointer commands = library.BRConnectCmd("127.0.0.1", Integer.parseInt(arguments[1]));
        IntByReference order = new IntByReference();
        BoneDimension size = new BoneDimension();
        byte[] text = new byte[20000];
        System.out.println("commands " + library.ZeroOut(commands, 0) + " " + library.ZeroOut(commands, 99) + " " + library.ZeroOutAll(commands) + " "
            + library.GetBvhRotation(commands, order) + " " + order.getValue() + " " + library.GetBoneSize(commands, 0, size) + " " + (size.Head > 0) + " "
            + library.GetBvhHeader(commands, 0, text, text.length) + " " + new String(text, 0, 9, StandardCharsets.UTF_8));

        int before = frames.get();
        System.out.println("signals " + useSignals());
        while (frames.get() < before + 20)
            Thread.sleep(1);

        library.BRCloseSocket(connection);
        int after = frames.get();
        library.BRCloseSocket(commands);
        System.out.println("closed " + (wrong.get() == 0) + " " + library.BRGetSocketStatus(connection) + " " + (frames.get() == after));
    }

    // The virtual machine catches SIGSEGV for null references, for the stops of its garbage collection, and for stack overflows.
    private static String useSignals() throws Exception {
        AtomicLong spun = new AtomicLong();
        Thread spinning = new Thread(() -> {
            long sum = 0;
            for (int round = 0; round < 5; round++) {
                for (int i = 0; i < 10_000_000; i++)
                    sum += i ^ round;
            }
            spun.set(sum);
        });
        spinning.start();
        int caught = 0;
        for (int i = 0; i < 50_000; i++) {
            try {
                nothing.hashCode();
            } catch (NullPointerException exception) {
                caught++;
            }
            if (i % 10_000 == 0)
                System.gc();
        }
        for (int i = 0; i < 5; i++) {
            try {
                fall(1);
            } catch (StackOverflowError error) {
                caught++;
            }
        }
        try (Memory memory = new Memory(8)) {
            memory.setLong(0, caught);
            spinning.join();
            return memory.getLong(0) + " " + (spun.get() != 0);
        }
    }

    private static int fall(int depth) {
        return fall(depth + 1) + 1;
    }
}
