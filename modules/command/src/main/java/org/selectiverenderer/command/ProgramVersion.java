package org.selectiverenderer.command;

import java.io.IOException;
import java.io.InputStream;
import java.util.Objects;
import java.util.Properties;
import picocli.CommandLine.IVersionProvider;

/** The program's name and version, which the build writes into {@code version.properties}. */
public final class ProgramVersion implements IVersionProvider {
  /** The program's name, as typed. */
  public static final String PROGRAM = "selective-renderer";

  @Override
  public String[] getVersion() throws IOException {
    return new String[] {PROGRAM + " " + number()};
  }

  /** Returns the version number alone. */
  public static String number() throws IOException {
    Properties properties = new Properties();
    try (InputStream in =
        Objects.requireNonNull(ProgramVersion.class.getResourceAsStream("version.properties"))) {
      properties.load(in);
    }
    return properties.getProperty("version");
  }
}
