package org.selectiverenderer.models.draco;

import com.openize.drako.DataType;
import com.openize.drako.Draco;
import com.openize.drako.DracoMesh;
import com.openize.drako.DrakoException;
import com.openize.drako.PointAttribute;
import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.selectiverenderer.base.platform.ParentProcessWatcher;

/** Decodes meshes in a child process, until its standard input ends. */
public final class DracoMain {
  private DracoMain() {}

  /** Runs the child process. */
  public static void main(String[] arguments) throws IOException {
    ParentProcessWatcher.whenItEnds(() -> Runtime.getRuntime().halt(1));
    // Not System.in and System.out, of which the library could make use.
    try (DataInputStream in =
            new DataInputStream(
                new BufferedInputStream(
                    new FileInputStream(FileDescriptor.in), DracoProtocol.BUFFER));
        DataOutputStream out =
            new DataOutputStream(
                new BufferedOutputStream(
                    new FileOutputStream(FileDescriptor.out), DracoProtocol.BUFFER))) {
      while (true) {
        long most;
        try {
          most = in.readLong();
        } catch (EOFException e) {
          return;
        }
        byte[] packed = new byte[in.readInt()];
        in.readFully(packed);
        answer(packed, most, out);
        out.flush();
      }
    }
  }

  private static void answer(byte[] packed, long most, DataOutputStream out) throws IOException {
    ByteArrayOutputStream answer = new ByteArrayOutputStream();
    try {
      int status = write(packed, most, new DataOutputStream(answer));
      out.writeByte(status);
      if (status == DracoProtocol.MESH) {
        answer.writeTo(out);
      }
    } catch (DrakoException | RuntimeException | StackOverflowError e) {
      // The library checks little, so that damage ends anywhere.
      out.writeByte(DracoProtocol.DAMAGED);
    } catch (OutOfMemoryError e) {
      out.writeByte(DracoProtocol.TOO_LARGE);
    }
  }

  private static int write(byte[] packed, long most, DataOutputStream out)
      throws DrakoException, IOException {
    if (!(Draco.decode(packed) instanceof DracoMesh mesh)
        || mesh.getNumAttributes() > DracoProtocol.MAX_ATTRIBUTES) {
      return DracoProtocol.DAMAGED; // or a cloud of points, which glTF has not
    }
    long values = 3L * mesh.getNumFaces();
    for (int i = 0; i < mesh.getNumAttributes(); i++) {
      values += (long) mesh.getNumPoints() * mesh.attribute(i).getComponentsCount();
    }
    if (values > most) {
      return DracoProtocol.TOO_LARGE;
    }
    out.writeInt(mesh.getNumPoints());
    out.writeInt(3 * mesh.getNumFaces());
    for (int i = 0; i < 3 * mesh.getNumFaces(); i++) {
      out.writeInt(mesh.readCorner(i));
    }
    out.writeInt(mesh.getNumAttributes());
    for (int i = 0; i < mesh.getNumAttributes(); i++) {
      write(mesh.attribute(i), mesh.getNumPoints(), out);
    }
    return DracoProtocol.MESH;
  }

  private static void write(PointAttribute attribute, int points, DataOutputStream out)
      throws IOException {
    int components = attribute.getComponentsCount();
    int type = attribute.getDataType();
    out.writeInt(Short.toUnsignedInt(attribute.getUniqueId()));
    out.writeInt(components);
    out.writeBoolean(type != DataType.FLOAT32);
    ByteBuffer bytes =
        ByteBuffer.wrap(attribute.getBuffer().getBuffer()).order(ByteOrder.LITTLE_ENDIAN);
    for (int point = 0; point < points; point++) {
      int at = attribute.getBytePos(attribute.mappedIndex(point));
      for (int k = 0; k < components; k++) {
        out.writeFloat(value(bytes, type, at, k));
      }
    }
  }

  private static float value(ByteBuffer bytes, int type, int at, int component) {
    return switch (type) {
      case DataType.INT8 -> bytes.get(at + component);
      case DataType.UINT8, DataType.BOOL -> bytes.get(at + component) & 0xff;
      case DataType.INT16 -> bytes.getShort(at + 2 * component);
      case DataType.UINT16 -> bytes.getShort(at + 2 * component) & 0xffff;
      case DataType.INT32 -> bytes.getInt(at + 4 * component);
      case DataType.UINT32 -> Integer.toUnsignedLong(bytes.getInt(at + 4 * component));
      case DataType.FLOAT32 -> bytes.getFloat(at + 4 * component);
      default -> throw new IllegalArgumentException("glTF has no numbers of that type");
    };
  }
}
