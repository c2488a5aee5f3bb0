package org.selectiverenderer;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.ModifiersTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.DocTrees;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePathScanner;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import javax.lang.model.element.Modifier;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;

/**
 * Whatever users of the libraries can name has a sentence of its own, or that of what it
 * implements.
 */
class DocumentedApiTest {
  private static final List<String> MODULES =
      List.of(
          "base",
          "chart",
          "control",
          "formats",
          "geometry",
          "polygon",
          "sai",
          "sai-extensions",
          "schema",
          "statistics",
          "validation",
          "x3d");

  @Test
  void allThatUsersOfALibraryCanNameIsDescribed() throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    List<String> silent = new ArrayList<>();
    int described = 0;
    try (StandardJavaFileManager files =
        compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
      JavacTask task =
          (JavacTask)
              compiler.getTask(
                  null, files, null, List.of(), null, files.getJavaFileObjectsFromPaths(sources()));
      DocTrees comments = DocTrees.instance(task);
      for (CompilationUnitTree unit : task.parse()) {
        Scan scan = new Scan(comments, unit, silent);
        scan.scan(unit, null);
        described += scan.described;
      }
    }
    assertThat(described).isGreaterThan(1000);
    assertThat(silent).isEmpty();
  }

  private static List<Path> sources() throws IOException {
    List<Path> sources = new ArrayList<>();
    for (String module : MODULES) {
      try (Stream<Path> files = Files.walk(Path.of("modules", module, "src/main/java"))) {
        files.filter(file -> file.toString().endsWith(".java")).sorted().forEach(sources::add);
      }
    }
    return sources;
  }

  /** Looks at what can be named from outside, and at nothing within methods. */
  private static final class Scan extends TreePathScanner<Void, Void> {
    private static final Set<Tree.Kind> OPEN =
        Set.of(Tree.Kind.INTERFACE, Tree.Kind.ANNOTATION_TYPE);

    private final DocTrees comments;
    private final CompilationUnitTree unit;
    private final List<String> silent;
    private int described;

    Scan(DocTrees comments, CompilationUnitTree unit, List<String> silent) {
      this.comments = comments;
      this.unit = unit;
      this.silent = silent;
    }

    @Override
    public Void visitClass(ClassTree type, Void none) {
      if (isVisible(type.getModifiers())) {
        note(type.getSimpleName());
        super.visitClass(type, none);
      }
      return null;
    }

    @Override
    public Void visitMethod(MethodTree method, Void none) {
      boolean inherits =
          method.getModifiers().getAnnotations().stream()
              .anyMatch(annotation -> annotation.getAnnotationType().toString().equals("Override"));
      if (isVisible(method.getModifiers()) && !inherits) {
        note(method.getName());
      }
      return null;
    }

    @Override
    public Void visitVariable(VariableTree field, Void none) {
      if (isVisible(field.getModifiers())) {
        note(field.getName());
      }
      return null;
    }

    private boolean isVisible(ModifiersTree modifiers) {
      Set<Modifier> flags = modifiers.getFlags();
      boolean inInterface = OPEN.contains(getCurrentPath().getParentPath().getLeaf().getKind());
      return flags.contains(Modifier.PUBLIC)
          || flags.contains(Modifier.PROTECTED)
          || inInterface && !flags.contains(Modifier.PRIVATE);
    }

    private void note(CharSequence name) {
      if (comments.getDocComment(getCurrentPath()) == null) {
        long line =
            unit.getLineMap()
                .getLineNumber(
                    comments
                        .getSourcePositions()
                        .getStartPosition(unit, getCurrentPath().getLeaf()));
        silent.add(Path.of(unit.getSourceFile().getName()) + ":" + line + ": " + name);
      } else {
        described++;
      }
    }
  }
}
