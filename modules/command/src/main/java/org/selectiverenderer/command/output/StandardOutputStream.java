package org.selectiverenderer.command.output;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/**
 * The process's standard output, wrapped by a {@link java.io.PrintStream}: throws {@link
 * StandardOutputException} at the first write that fails, and discards later data so that closing
 * does not fail.
 */
public final class StandardOutputStream extends FilterOutputStream {
  private boolean failed;

  public StandardOutputStream(OutputStream target) {
    super(target);
  }

  @Override
  public void write(int b) {
    write(new byte[] {(byte) b}, 0, 1);
  }

  @Override
  public void write(byte[] bytes, int offset, int length) {
    attempt(() -> out.write(bytes, offset, length));
  }

  @Override
  public void flush() {
    attempt(out::flush);
  }

  private void attempt(Writing writing) {
    if (failed) {
      return;
    }
    try {
      writing.run();
    } catch (IOException e) {
      failed = true;
      throw new StandardOutputException(e);
    }
  }

  private interface Writing {
    void run() throws IOException;
  }
}
