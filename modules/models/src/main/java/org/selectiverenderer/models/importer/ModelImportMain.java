package org.selectiverenderer.models.importer;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import org.selectiverenderer.base.platform.ParentProcessWatcher;

/** Reads models in a child process, until its standard input ends. */
public final class ModelImportMain {
  private static final int BUFFER = 1 << 16;

  private ModelImportMain() {}

  /** Runs the child process. */
  public static void main(String[] arguments) throws IOException {
    ParentProcessWatcher.whenItEnds(() -> Runtime.getRuntime().halt(1));
    // Not System.in and System.out, of which others could make use.
    try (DataInputStream in =
            new DataInputStream(
                new BufferedInputStream(new FileInputStream(FileDescriptor.in), BUFFER));
        DataOutputStream out =
            new DataOutputStream(
                new BufferedOutputStream(new FileOutputStream(FileDescriptor.out), BUFFER))) {
      out.writeInt(ImportProtocol.MAGIC);
      out.writeInt(ImportProtocol.VERSION);
      out.writeUTF(AssimpImporter.load());
      out.flush();
      for (int request = in.read();
          request == ImportProtocol.READ_MESHES || request == ImportProtocol.READ_SCENE;
          request = in.read()) {
        String name = in.readUTF();
        boolean whole = request == ImportProtocol.READ_SCENE;
        new AssimpImporter(new ServedFileIo(in, out), whole).read(name, out);
        out.flush();
      }
    }
  }
}
