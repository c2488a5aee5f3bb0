package org.selectiverenderer.export;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.x3d.source.Gzip;
import org.selectiverenderer.x3d.url.UrlRelativizer;

/**
 * An exported scene in a folder for web servers, its texts compressed, as most servers do not
 * compress files of these types themselves.
 *
 * @param files the scene, and then the files that it names
 * @param controller DEF name of the Script that sets the choices; empty without one
 * @param plainBytes the bytes of the texts before they were compressed
 * @param normalMaps whether a file may use a normal map, for which the page prepares models longer
 */
public record WebScene(
    List<PackagedFile> files, Optional<String> controller, long plainBytes, boolean normalMaps) {
  /** The file name endings of scenes as text, and those of their compressed form (X3D 19776-1). */
  private static final Map<String, String> COMPRESSED =
      Map.of(".x3d", ".x3dz", ".x3dv", ".x3dvz", ".wrl", ".wrz");

  public WebScene {
    files = List.copyOf(files);
  }

  /**
   * Packs a scene that was exported with {@link #name} for its files.
   *
   * @param under its folder, relative to that of the page
   * @throws IOException if a file cannot be read, with a sentence
   */
  public static WebScene of(ExportedScene exported, Path under) throws IOException {
    return of(exported, exported.files().scene(), under);
  }

  /**
   * Packs a scene whose own file has been changed.
   *
   * @param scene the scene's own file
   */
  static WebScene of(ExportedScene exported, PackagedFile scene, Path under) throws IOException {
    List<PackagedFile> sources = new ArrayList<>(List.of(scene));
    sources.addAll(exported.files().files());
    List<PackagedFile> files = new ArrayList<>();
    long plain = 0;
    boolean normalMaps = false;
    for (PackagedFile file : sources) {
      Path target = under.resolve(file.target());
      if (COMPRESSED.containsValue(ending(file.target()))) {
        byte[] bytes =
            file.changed().isPresent()
                ? file.changed().get()
                : InputFileReader.bytes(file.source());
        plain += bytes.length;
        normalMaps |= NormalMaps.mentioned(file.target(), bytes);
        byte[] packed = Gzip.compressed(bytes) ? bytes : Gzip.packed(bytes);
        files.add(new PackagedFile(target, file.source(), Optional.of(packed)));
      } else {
        normalMaps |= NormalMaps.mentioned(file);
        files.add(new PackagedFile(target, file.source(), file.changed()));
      }
    }
    return new WebScene(files, exported.controller(), plain, normalMaps);
  }

  /** Returns the name of a scene's file in the folder: one of text tells that it is compressed. */
  public static String name(String name) {
    String compressed = COMPRESSED.get(ending(Path.of(name)));
    return compressed == null ? name : name.substring(0, name.lastIndexOf('.')) + compressed;
  }

  /** Puts where the scene and its controller are, and the bytes of its files, into an object. */
  public void describe(ObjectNode json) throws IOException {
    json.put("file", url(files.get(0)));
    controller.ifPresent(name -> json.put("controller", name));
    json.put("normalMaps", normalMaps);
    ObjectNode sizes = json.putObject("files");
    for (PackagedFile file : files) {
      sizes.put(url(file), file.size());
    }
  }

  private static String ending(Path file) {
    String name = String.valueOf(file.getFileName());
    int dot = name.lastIndexOf('.');
    return dot < 1 ? "" : name.substring(dot).toLowerCase(Locale.ROOT);
  }

  private static String url(PackagedFile file) {
    return UrlRelativizer.between(Path.of(""), file.target());
  }
}
