package org.selectiverenderer.authoring.packaging;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import org.selectiverenderer.base.files.FileNameLength;
import org.selectiverenderer.base.files.WindowsDeviceName;

/**
 * Places files in a target folder as they lie around the scene: a file beside or below it keeps its
 * relative place, one that lies elsewhere loses the steps upwards, so that {@code
 * ../inlineNodes/desk.x3d} becomes {@code inlineNodes/desk.x3d}. No two files get the same place,
 * also where upper and lower case are the same.
 */
public final class PackageLayout {
  /** Matches what Windows takes in no name: characters, and a dot or blank at the end. */
  private static final Pattern FORBIDDEN = Pattern.compile("[<>:\"|?*\\\\\\x00-\\x1f]|[. ]+$");

  private static final int LONGEST_ENDING = 32;

  private final Path folder;
  private final Path into;
  private final Optional<Path> kept;
  private final UnaryOperator<String> names;
  private final Map<Path, Path> places = new HashMap<>();
  private final Set<String> taken = new HashSet<>();

  private PackageLayout(Path folder, Path into, Optional<Path> kept, UnaryOperator<String> names) {
    this.folder = folder;
    this.names = names;
    this.into = into;
    this.kept = kept;
  }

  /**
   * Creates a layout of all files around a scene.
   *
   * @param folder the real path of the scene's folder
   */
  public static PackageLayout around(Path folder) {
    return around(folder, UnaryOperator.identity());
  }

  /**
   * Creates a layout of all files around a scene that gives them other names.
   *
   * @param folder the real path of the scene's folder
   * @param names turns the name of a file into that which it gets
   */
  public static PackageLayout around(Path folder, UnaryOperator<String> names) {
    return new PackageLayout(folder, Path.of(""), Optional.empty(), names);
  }

  /**
   * Creates a layout in which files of the target folder stay, and others get into a folder in it.
   *
   * @param folder the real path of the folder of the file that names them
   * @param target the real path of the target folder
   * @param into the relative path of the folder for the others
   */
  public static PackageLayout beside(Path folder, Path target, Path into) {
    return new PackageLayout(folder, into, Optional.of(target), UnaryOperator.identity());
  }

  /** Reserves a place. */
  void place(Path real, Path target) {
    places.put(real, target);
    taken.add(key(target));
  }

  /** Returns whether a file stays where it is, as it is in the target folder already. */
  boolean stays(Path real) {
    return kept.filter(real::startsWith).isPresent();
  }

  /** Returns the place of a file relative to the target folder. */
  Path of(Path real) {
    return places.computeIfAbsent(
        real,
        file -> stays(file) ? kept.get().relativize(file) : free(into.resolve(named(own(file)))));
  }

  private Path named(Path place) {
    return place.resolveSibling(names.apply(String.valueOf(place.getFileName())));
  }

  private Path own(Path real) {
    Path name = Objects.requireNonNull(real.getFileName());
    if (!Objects.equals(folder.getRoot(), real.getRoot())) {
      return visible(name);
    }
    Path relative = folder.relativize(real);
    int up = 0;
    while (up < relative.getNameCount() - 1 && relative.getName(up).toString().equals("..")) {
      up++;
    }
    return visible(relative.subpath(up, relative.getNameCount()));
  }

  /**
   * Returns a path without leading dots, as scenes may not name hidden files, and of names that
   * every system takes, Windows too.
   */
  private static Path visible(Path relative) {
    Path shown = Path.of("");
    for (Path part : relative) {
      String name = part.toString();
      shown = shown.resolve(portable(name.startsWith(".") ? "_" + name.substring(1) : name));
    }
    return shown;
  }

  /** Returns a name without what Windows forbids in names (Microsoft, "Naming Files"). */
  private static String portable(String name) {
    String plain = FORBIDDEN.matcher(name).replaceAll("_");
    return WindowsDeviceName.matches(plain) ? fitted("_" + plain, "") : plain;
  }

  private Path free(Path wanted) {
    Path place = wanted;
    String name = wanted.getFileName().toString();
    for (int i = 2; !taken.add(key(place)); i++) {
      place = wanted.resolveSibling(fitted(name, "-" + i));
    }
    return place;
  }

  /** Returns a name with a part added before its ending, so that file systems take it. */
  private static String fitted(String name, String added) {
    int dot = name.indexOf('.', 1);
    String ending = dot < 0 ? "" : name.substring(dot);
    if (ending.length() > LONGEST_ENDING) {
      ending = "";
    }
    String stem = name.substring(0, name.length() - ending.length());
    int more = (added + ending).getBytes(StandardCharsets.UTF_8).length;
    return FileNameLength.shortened(stem, more) + added + ending;
  }

  private static String key(Path place) {
    return place.toString().replace('\\', '/').toLowerCase(Locale.ROOT);
  }
}
