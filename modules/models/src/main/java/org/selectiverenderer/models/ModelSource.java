package org.selectiverenderer.models;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.Channels;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.selectiverenderer.models.importer.ModelFileSource.OpenFile;
import org.selectiverenderer.x3d.model.ModelFile;
import org.selectiverenderer.x3d.url.BaseUrl;

/**
 * A model that Assimp reads.
 *
 * @param name the name in problems
 * @param fileName the name by which Assimp asks for it: without folders, which it would open, and
 *     with the ending of its format
 * @param base the base of its relative urls
 * @param content opens its bytes
 */
record ModelSource(String name, String fileName, BaseUrl base, Content content) {
  private static final int LONGEST_NAME = 255;

  /** Opens the bytes of a model. */
  @FunctionalInterface
  interface Content {
    OpenFile open() throws IOException;
  }

  /** Returns the model in a file. */
  static ModelSource of(Path file) {
    String name = String.valueOf(file.getFileName());
    boolean usual = name.indexOf('\\') < 0 && name.length() <= LONGEST_NAME;
    return new ModelSource(
        file.toString(),
        usual ? name : "model" + name.substring(name.lastIndexOf('.')),
        BaseUrl.folder(ModelReader.folder(file)),
        () -> open(file));
  }

  /** Returns a model in memory. */
  static ModelSource of(ModelFile model) {
    return new ModelSource(
        model.name(),
        "model." + model.format().ending(),
        model.base(),
        () ->
            new OpenFile(
                model.length(), new ByteArrayInputStream(model.bytes(), 0, model.length())));
  }

  /** Opens a file with its size. */
  static OpenFile open(Path path) throws IOException {
    SeekableByteChannel channel = Files.newByteChannel(path);
    try {
      return new OpenFile(channel.size(), Channels.newInputStream(channel));
    } catch (IOException e) {
      channel.close();
      throw e;
    }
  }

  /** Opens the bytes. */
  InputStream open() throws IOException {
    return content.open().content();
  }

  /** Returns the ending of the format, in lower case. */
  String ending() {
    return fileName.substring(fileName.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
  }
}
