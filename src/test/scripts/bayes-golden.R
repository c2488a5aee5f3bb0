# Makes bayes-data.csv and bayes-golden.csv; see README.md beside this file.
suppressMessages(library(BayesFactor))
folder <- commandArgs(trailingOnly = TRUE)[1]
set.seed(20120808)
data_lines <- "set,subject,a,b,u,value"
lines <- "set,effect,bf01,error,from"

term <- function(name) {
  parts <- strsplit(name, ":")[[1]]
  paste(c(intersect("u", parts), intersect(c("a", "b"), parts)), collapse = " x ")
}

# The design matrix of a term as in BayesFactor: orthonormal contrasts of each factor (its "fixed"
# coding), multiplied for interactions.
contrast <- function(k) eigen(diag(k) - 1 / k)$vectors[, seq_len(k - 1), drop = FALSE]
columns <- function(d, name) {
  x <- matrix(1, nrow(d), 1)
  for (f in strsplit(name, ":")[[1]]) {
    own <- contrast(nlevels(d[[f]]))[as.integer(d[[f]]), , drop = FALSE]
    x <- do.call(cbind, lapply(seq_len(ncol(x)), function(i) x[, i] * own))
  }
  x
}

# log of the evidence by brute force: all g in equal steps of their logarithms, the full N x N
# covariance at each. Equation 8 and appendix of Rouder et al. (2012), nothing taken apart.
evidence <- function(d, terms, random, step = 0.5, from = -6, to = 14, r = 0.5) {
  y <- d$value; n <- length(y); one <- rep(1, n)
  parts <- lapply(terms, function(t) tcrossprod(columns(d, t))); scales <- rep(r, length(terms))
  if (random) {
    parts <- c(parts, list(tcrossprod(outer(as.integer(d$subject), seq_len(nlevels(d$subject)), "==") * 1)))
    scales <- c(scales, 1)
  }
  if (!length(parts)) { # no g at all
    return(-(n - 1) / 2 * log(sum((y - mean(y))^2)) - log(n) / 2)
  }
  grid <- as.matrix(expand.grid(rep(list(seq(from, to, step)), length(parts))))
  logs <- apply(grid, 1, function(u) {
    v <- diag(n); for (i in seq_along(parts)) v <- v + exp(u[i]) * parts[[i]]
    root <- chol(v); z <- backsolve(root, cbind(y, one), transpose = TRUE)
    s <- crossprod(z); q <- s[1, 1] - s[1, 2]^2 / s[2, 2]
    prior <- sum(log(scales) - log(2 * pi) / 2 - u / 2 - scales^2 / 2 * exp(-u))
    prior - sum(log(diag(root))) - log(s[2, 2]) / 2 - (n - 1) / 2 * log(q)
  })
  max(logs) + log(sum(exp(logs - max(logs)))) + ncol(grid) * log(step)
}

put <- function(set, name, bf01, error, from)
  lines[length(lines) + 1] <<- sprintf("%d,%s,%.12g,%.3g,%s", set, term(name), bf01, error, from)

# Each effect: the model of all terms that do not contain it, against the same and it.
effects <- function(set, d, terms, random, by, ...) {
  for (t in terms) {
    own <- strsplit(t, ":")[[1]]
    without <- Filter(function(o) !all(own %in% strsplit(o, ":")[[1]]), terms)
    if ("brute force" %in% by)
      put(set, t, exp(evidence(d, without, random, ...) - evidence(d, c(without, t), random, ...)), 0, "brute force")
    if ("lmBF" %in% by) {
      fit <- function(own) if (!length(own) && !random) NULL else
        lmBF(as.formula(paste("value ~", paste(c(own, if (random) "subject"), collapse = " + "))), d,
             whichRandom = if (random) "subject", rscaleFixed = 0.5, rscaleRandom = 1, iterations = 20000, progress = FALSE)
      null <- fit(without); full <- fit(c(without, t))
      bf <- function(x) if (is.null(x)) 1 else extractBF(x)$bf
      err <- function(x) if (is.null(x)) 0 else extractBF(x)$error
      put(set, t, bf(null) / bf(full), sqrt(err(null)^2 + err(full)^2), "lmBF")
    }
  }
}

make <- function(n, k, effect, spread = 1) { # n: a table of group sizes by a and b
  cells <- do.call(rbind, lapply(seq_len(nrow(n)), function(i) do.call(rbind, lapply(seq_len(ncol(n)), function(j)
    data.frame(a = rep(i, n[i, j]), b = rep(j, n[i, j]))))))
  d <- data.frame(subject = rep(seq_len(nrow(cells)), each = k), a = rep(cells$a, each = k), b = rep(cells$b, each = k),
                  u = rep(seq_len(k), nrow(cells)))
  d$value <- rnorm(nrow(d)) + rnorm(nrow(cells), 0, spread)[d$subject] * (k > 1) + effect * (d$a * d$u / 2 + d$b / 3)
  d$value <- round(d$value, 3)
  for (f in c("subject", "a", "b", "u")) d[[f]] <- factor(d[[f]])
  d
}
write_data <- function(set, d) data_lines <<- c(data_lines, sprintf("%d,%s,%s,%s,%s,%.15g", set, d$subject,
  if (nlevels(d$a) > 1) d$a else "", if (nlevels(d$b) > 1) d$b else "", if (nlevels(d$u) > 1) d$u else "", d$value))
col <- function(...) matrix(c(...), ncol = 1)

set <- 0
for (n in list(col(8, 8, 8), col(5, 9, 4), col(12, 7))) for (effect in c(0, 1.5)) { # one-way
  set <- set + 1; d <- make(n, 1, effect); write_data(set, d)
  effects(set, d, "a", FALSE, c("brute force", "lmBF"), step = 0.25, from = -8, to = 22)
}
for (k in c(2, 4)) for (effect in c(0, 0.5)) { # repeated measures
  set <- set + 1; d <- make(col(9), k, effect); write_data(set, d)
  effects(set, d, "u", TRUE, c("brute force", "lmBF"), step = 0.5, from = -6, to = 18)
}
for (n in list(col(4, 4, 4), col(3, 5, 4))) { # mixed
  set <- set + 1; d <- make(n, 2, 0.5); write_data(set, d)
  effects(set, d, c("a", "u", "a:u"), TRUE, c("lmBF"))
}
set <- set + 1; d <- make(col(5, 3), 2, 0.3); write_data(set, d)
effects(set, d, c("a", "u", "a:u"), TRUE, c("brute force"), step = 0.9, from = -5.4, to = 12.6)
for (n in list(matrix(3, 2, 2), matrix(c(3, 6, 5, 4), 2))) { # two between
  set <- set + 1; d <- make(n, 1, 0.5); write_data(set, d)
  effects(set, d, c("a", "b", "a:b"), FALSE, c("brute force", "lmBF"), step = 0.7, from = -5.6, to = 16.8)
}
set <- set + 1; d <- make(matrix(c(3, 6, 5, 4), 2), 2, 0.4); write_data(set, d) # two between, one within
effects(set, d, c("a", "b", "u", "a:b", "a:u", "b:u", "a:b:u"), TRUE, "lmBF")
# The case of a mixed design in which BIC speaks 33 to 1 for the null: F(9, 96) = 4.10.
set <- set + 1; d <- make(col(9, 9, 9, 9), 4, 0)
at <- function(k) {
  inter <- with(d, ave(value, a, u) - ave(value, a) - ave(value, u) + mean(value))
  d$value + (k - 1) * inter
}
f <- function(k) { d$value <- at(k); summary(aov(value ~ a * u + Error(subject/u), d))[[2]][[1]]["a:u", "F value"] - 4.10 }
d$value <- at(uniroot(f, c(0.01, 50), tol = 1e-10)$root); write_data(set, d)
effects(set, d, c("a", "u", "a:u"), TRUE, "lmBF")

# Published or printed values of F alone, one-way: BayesFactor's own one-dimensional integral.
for (case in list(c(0.576, 18, 3), c(4, 10, 4), c(12, 20, 2), c(1, 50, 5), c(40, 8, 3))) {
  bf <- oneWayAOV.Fstat(case[1], N = case[2], J = case[3], rscale = 0.5)$bf
  lines[length(lines) + 1] <- sprintf("0,F(%g;%g;%g),%.12g,1e-6,oneWayAOV.Fstat", case[1], case[2], case[3], exp(-bf))
}
writeLines(data_lines, file.path(folder, "bayes-data.csv")); writeLines(lines, file.path(folder, "bayes-golden.csv"))
cat(length(lines) - 1, "Bayes factors\n")
