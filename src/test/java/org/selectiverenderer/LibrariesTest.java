package org.selectiverenderer;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** What a library's classes need is in its jar, or in what its POM names. */
@AnalyzeClasses(
    packages = {"org.selectiverenderer", "org.web3d.x3d.sai"},
    importOptions = DoNotIncludeTests.class)
class LibrariesTest {
  private static final String SAI = "org.web3d.x3d.sai";

  /** The packages of each library of others, and the artifact that brings it. */
  private static final Map<String, String> OTHERS =
      Map.of(
          "ch.randelshofer.fastdoubleparser", "fastdoubleparser",
          "com.fasterxml.aalto", "aalto-xml",
          "org.codehaus.stax2", "aalto-xml", // which brings it
          "com.fasterxml.jackson", "jackson-databind",
          "earcut4j", "earcut4j",
          "org.apache.commons.csv", "commons-csv",
          "org.apache.commons.math3", "commons-math3",
          "org.joml", "joml",
          "org.jspecify", "jspecify",
          "org.mozilla", "rhino");

  @ArchTest
  static void noPackageIsInTwoLibraries(JavaClasses ours) throws IOException {
    List<Library> libraries = Library.all();
    assertThat(libraries).hasSizeGreaterThan(1);
    for (JavaClass type : ours) {
      assertThat(libraries.stream().filter(library -> library.holds(type.getPackageName())))
          .as(type.getPackageName())
          .hasSizeLessThan(2);
    }
  }

  @ArchTest
  static void aPomNamesWhatTheClassesUseAndNothingElse(JavaClasses ours) throws IOException {
    List<Library> libraries = Library.all();
    for (Library library : libraries) {
      Set<String> used = new TreeSet<>();
      for (JavaClass type : held(library, ours)) {
        type.getDirectDependenciesFromSelf().stream()
            .map(use -> use.getTargetClass().getBaseComponentType().getPackageName())
            .filter(name -> !library.holds(name))
            .flatMap(name -> artifact(name, libraries).stream())
            .forEach(used::add);
      }
      assertThat(used)
          .as("what %s uses", library.artifact())
          .containsExactlyInAnyOrderElementsOf(library.uses());
    }
  }

  /** A class of another library may need more than that library's user has. */
  @ArchTest
  static void librariesThatDoNotNameTheSaiDoNotReachIt(JavaClasses ours) throws IOException {
    for (Library library : Library.all()) {
      if (library.holds(SAI) || library.uses().contains("x3d-sai")) {
        continue;
      }
      Deque<JavaClass> pending = new ArrayDeque<>(held(library, ours));
      Set<JavaClass> seen = new HashSet<>(pending);
      while (!pending.isEmpty()) {
        JavaClass type = pending.pop();
        assertThat(type.getPackageName())
            .as("reached by %s", library.artifact())
            .doesNotStartWith(SAI);
        type.getDirectDependenciesFromSelf().stream()
            .map(use -> use.getTargetClass().getBaseComponentType())
            .filter(used -> isOurs(used.getPackageName()) && seen.add(used))
            .forEach(pending::add);
      }
    }
  }

  private static List<JavaClass> held(Library library, JavaClasses ours) {
    List<JavaClass> held =
        ours.stream().filter(type -> library.holds(type.getPackageName())).toList();
    assertThat(held).as(library.artifact()).isNotEmpty();
    return held;
  }

  /** What brings a package; empty for Java itself. */
  private static Optional<String> artifact(String name, List<Library> libraries) {
    if (isOurs(name)) {
      return Optional.of(
          libraries.stream()
              .filter(library -> library.holds(name))
              .map(Library::artifact)
              .findFirst()
              .orElse(name + ", which is in no library"));
    }
    if (name.isEmpty()
        || (name.startsWith("java.") && !name.startsWith("java.awt"))
        || name.startsWith("javax.xml.")
        || name.startsWith("org.w3c.dom")) {
      return Optional.empty();
    }
    return Optional.of(
        OTHERS.entrySet().stream()
            .filter(other -> (name + ".").startsWith(other.getKey() + "."))
            .map(Map.Entry::getValue)
            .findFirst()
            .orElse(name + ", which no POM names"));
  }

  private static boolean isOurs(String name) {
    return name.startsWith("org.selectiverenderer") || name.startsWith(SAI);
  }
}
