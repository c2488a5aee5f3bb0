package org.selectiverenderer.models.importer;

import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;

/** Decides which files a model may refer to, and opens them. */
@FunctionalInterface
public interface ModelFileSource {
  /**
   * An open file.
   *
   * @param size its exact size in bytes
   * @param content its bytes; closed by the caller
   */
  record OpenFile(long size, InputStream content) {}

  /**
   * Opens a file.
   *
   * @param url the url as the model states it, or the name under which the model itself is read
   * @return empty if the model must not read it, or there is none
   */
  Optional<OpenFile> open(String url) throws IOException;
}
