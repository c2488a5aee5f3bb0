package org.selectiverenderer.release;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;

/**
 * A folder with a copy of the project's scripts in {@code home}, and programs that stand in for
 * others.
 */
final class ScriptSandbox {
  final Path home;
  final Map<String, String> environment = new HashMap<>();
  private final Path tools;
  private final Path folder;

  /** What a script has printed, and its exit status. */
  record Run(int status, String out, String err) {}

  ScriptSandbox(Path folder) throws IOException {
    this.folder = folder;
    home = Files.createDirectories(folder.resolve("a home"));
    tools = Files.createDirectories(folder.resolve("tools"));
    environment.put("PATH", tools + ":" + System.getenv("PATH"));
    environment.put("NOTES", folder.resolve("notes").toString());
    for (String role : List.of("AUTHOR", "COMMITTER")) {
      environment.put("GIT_" + role + "_NAME", "A. Tester");
      environment.put("GIT_" + role + "_EMAIL", "tester@example.org");
    }
    environment.put("GIT_CONFIG_GLOBAL", "/dev/null");
    environment.put("GIT_CONFIG_NOSYSTEM", "1");
  }

  /** Copies files or folders of the project. */
  void copy(String... names) throws IOException {
    for (String name : names) {
      try (Stream<Path> paths = Files.walk(Path.of(name))) {
        for (Path path : (Iterable<Path>) paths.filter(Files::isRegularFile)::iterator) {
          if (!path.toString().endsWith(".pyc")) {
            Path copy = home.resolve(path.toString());
            Files.createDirectories(copy.getParent());
            Files.copy(path, copy);
          }
        }
      }
    }
  }

  void write(String name, String text) throws IOException {
    Path file = home.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  String read(String name) throws IOException {
    return Files.readString(home.resolve(name), StandardCharsets.UTF_8);
  }

  /** A program on the path, or in a JDK below {@link #tools()}. */
  void tool(String name, String script) throws IOException {
    Path file = tools.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, "#!/bin/sh\n" + script);
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
  }

  Path tools() {
    return tools;
  }

  /** What the programs have noted. */
  List<String> notes() throws IOException {
    Path notes = folder.resolve("notes");
    return Files.exists(notes) ? Files.readAllLines(notes) : List.of();
  }

  /** Runs a command in the home; a name with a slash is a script there. */
  Run run(String command, String... arguments) throws IOException, InterruptedException {
    Path out = folder.resolve("out");
    Path err = folder.resolve("err");
    String program = command.contains("/") ? home.resolve(command).toString() : command;
    ProcessBuilder builder =
        new ProcessBuilder(Stream.concat(Stream.of(program), Stream.of(arguments)).toList())
            .directory(home.toFile())
            .redirectOutput(out.toFile())
            .redirectError(err.toFile());
    builder
        .environment()
        .keySet()
        .removeIf(
            name ->
                Stream.of("SELECTIVE_RENDERER_", "GIT_", "GITHUB_", "INPUT_", "JAVA_HOME", "MAVEN_")
                    .anyMatch(name::startsWith));
    builder.environment().putAll(environment);
    Process process = builder.start();
    process.getOutputStream().close();
    int status = process.waitFor();
    return new Run(status, Files.readString(out), Files.readString(err));
  }

  /** What git prints; without git the test is skipped. */
  String git(String... arguments) throws IOException, InterruptedException {
    Run run;
    try {
      run = run("git", arguments);
    } catch (IOException e) {
      Assumptions.abort("git is not on the path");
      throw e;
    }
    if (run.status() != 0) {
      throw new IOException("git " + String.join(" ", arguments) + ": " + run.err());
    }
    return run.out().strip();
  }

  static String sha256(Path file) throws IOException {
    try {
      byte[] sum = MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(file));
      return HexFormat.of().formatHex(sum);
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("every Java has SHA-256", e);
    }
  }
}
