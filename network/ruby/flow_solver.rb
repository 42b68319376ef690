#!/usr/bin/env ruby
# SPDX-License-Identifier: GPL-3.0-or-later
# A flow solver in Ruby, written from docs/flow_solvers.md and docs/protocol.md alone: implicit, one Newtonian fluid,
# leak-off, contact, stages of given rate. Numbers in brackets are equations of that page. Debian: ruby, ruby-ffi-rzmq.
%w[digest ffi-rzmq json zlib].each { |library| require library }
TYPES = { hello: 1, welcome: 2, reject: 3, insert: 11, acknowledge: 12, advance: 20, pressure: 21, report: 30, fields: 31,
          finish: 50, bye: 51, fail: 60, progress: 61 }.freeze
UNITS = Hash[*%w[aperture m aperture_rate m/s reference_pressure Pa compliance m/Pa closed 1 arm_aperture_a m
                 arm_aperture_b m pressure Pa aperture_predicted m filled 1 content m leaked m]].freeze
ENVELOPE, MEGAPASCAL, NUDGE, ROUNDING, ANY, TIP = "a4CCS<a16L<L<Q<Q<Q<L<", 1e6, 1e-6, 2e-15, -Float::INFINITY, 1
Refusal = Class.new(StandardError) { attr_accessor :code }
Lost = Class.new(Refusal) # the coupler is gone: nobody is left to be told
def refuse(code, sentence, kind = Refusal) = raise(kind.new(sentence).tap { |refusal| refusal.code = code })
def now = Process.clock_gettime(Process::CLOCK_MONOTONIC)

Message = Struct.new(:type, :revision, :body, :arrays) do
  def value(key, kind) = body[key].is_a?(kind) ? body[key] : refuse(22, "#{type}: #{key} is #{body[key].inspect}")
  def numbers(name, count, least)
    values = arrays[name]
    refuse(22, "#{type}: #{name} must hold #{count} numbers") unless values.is_a?(Array) && values.size == count
    wrong = values.find { |value| !value.finite? || value < least }
    wrong ? refuse(23, "#{type}: #{name} holds #{wrong}, expected finite and at least #{least}") : values
  end
end

# Envelope, checksum and sequence numbers on one DEALER; notices when the coupler falls silent or is gone.
class Channel
  attr_writer :deadline
  def initialize(endpoint)
    context = ZMQ::Context.new
    @socket, @events, @poller = context.socket(ZMQ::DEALER), context.socket(ZMQ::PAIR), ZMQ::Poller.new
    { ZMQ::RECONNECT_IVL => -1, ZMQ::LINGER => 1000 }.each { |option, value| @socket.setsockopt(option, value) }
    LibZMQ.zmq_socket_monitor(@socket.socket, "inproc://events", ZMQ::EVENT_DISCONNECTED | ZMQ::EVENT_CLOSED)
    @events.connect("inproc://events")
    [@socket, @events].each { |socket| @poller.register_readable(socket) }
    @socket.connect(endpoint)
    @run, @epoch, @sent, @received, @interval, @deadline, @last_word, @last_progress = "\0" * 16, 0, 0, 0, 0, 60, now, now
    %w[TERM HUP].each { |name| trap(name) { @signal = Signal.list[name] } }
    trap("INT", "IGNORE")
  end

  def say(type, revision, body, arrays = {})
    frames = arrays.values.map { |values| values.pack("E*") }
    names = arrays.map { |name, values| { name:, dtype: "float64", shape: [values.size], unit: UNITS[name] } }
    text = JSON.generate(body.merge(arrays: names))
    head = ["FIS1", 1, 1, TYPES[type], @run, @epoch, frames.size, @sent, @interval, revision, text.bytesize].pack(ENVELOPE)
    @socket.send_strings([head + [Zlib.crc32([head, text.b, *frames].join)].pack("L<"), text, *frames])
    @sent += 1
  end

  # The next message but PROGRESS within `patience` seconds, or nil.
  def hear(patience)
    latest = now + patience
    begin
      @poller.poll((1000 * (latest - now).clamp(0, 0.1)).ceil)
      say(:progress, 0, { phase: "waiting", count: 0, stop_signal: @signal }) if @signal
      @signal, frames = nil, []
      if @poller.readables.include?(@socket) && @socket.recv_strings(frames, ZMQ::DONTWAIT) >= 0
        @last_word = now
        message = decode(*frames.map(&:b))
        refuse(20, "the coupler ended the run", Lost) if message.type == :fail
        return message unless message.type == :progress
      end
      refuse(20, "the connection to the coupler ended", Lost) if @poller.readables == [@events]
      refuse(21, "the coupler has said nothing for #{@deadline} s", Lost) if now - @last_word > @deadline
    end while now < latest
  end

  def progress # while at work
    return if now - @last_progress < 0.2
    @last_progress = now
    say(:progress, 0, { phase: "newton", count: 0 })
    message = hear(0) and refuse(22, "#{message.type} came while the solver is at work")
  end

  def decode(head, text = nil, *data)
    refuse(22, "message #{@received} has no envelope") unless text && head.bytesize == 64 && head[0, 4] == "FIS1"
    _, major, _, kind, run, epoch, count, sequence, interval, revision, length = head.unpack(ENVELOPE)
    refuse(13, "protocol version #{major} is not 1") if major != 1
    @run, @epoch = run, epoch if @received.zero?
    whole = Zlib.crc32([head[0, 60], text, *data].join) == head[60, 4].unpack1("L<") && TYPES.key(kind)
    whole &&= [run, epoch, sequence, count, length] == [@run, @epoch, @received, data.size, text.bytesize]
    refuse(22, "message #{@received} is damaged, lost, doubled, or of another run, epoch or type") unless whole
    @received += 1
    body = JSON.parse(text.force_encoding("UTF-8"))
    @interval = interval unless TYPES[:progress] == kind
    arrays = (body["arrays"] || []).zip(data).to_h do |declared, bytes|
      name, dtype, unit = declared.values_at("name", "dtype", "unit")
      whole = bytes && bytes.size == (dtype == "uint8" ? 1 : 8) * declared["shape"].inject(1, :*)
      refuse(22, "#{name} is too short or too long") unless whole
      refuse(13, "#{name} must be in #{UNITS[name]}, found #{unit}") if UNITS.fetch(name, unit) != unit
      [name, dtype == "float64" ? bytes.unpack("E*") : bytes]
    end
    Message.new(TYPES.key(kind), revision, body, arrays)
  end
end

# Fractures and the fluid in them, per unit thickness. Arrays are in the order of insertion; the well is one node more.
class FlowSolver
  def initialize(run_case, channel)
    @channel, @stages, @thickness = channel, run_case["injection"]["stages"], run_case["domain"]["thickness"]
    @carter, @spurt = run_case["leak_off"].values_at("coefficient", "spurt_volume")
    @floor, @tolerance, @limit = run_case["network"].values_at("minimum_aperture", "tolerance", "maximum_iterations")
    @mu, @stiffness = (run_case["fluids"][0] || {}).values_at("consistency_index", "bulk_modulus")
    @well_index, @dry = run_case["injection"]["well_index"], @stages.empty?
    positive = [@thickness, @floor, @tolerance, @limit] + (@dry ? [] : [@mu, @stiffness, @well_index])
    refuse(10, "a number of the case is out of its range") unless positive.all?(&:positive?) && [@carter, @spurt].min >= 0
    @nodes, @segments, @wells, @length, @content, @pressure, @leaked, @filled, @swept = Array.new(9) { [] }
    @time, @well_pressure, @rate, @rate_before, @injected, @lost, @place = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, {}
  end

  def insert(change) # section 5
    expect = ->(holds, sentence) { holds || refuse(22, "insertion: #{sentence}") }
    place = ->(id) { @place[id] || expect[false, "there is no node #{id}"] }
    expect[change["revision"] == (@revision || -1) + 1, "revision #{change["revision"]} is not the next"]
    before, @revision = @length, change["revision"]
    change["updated_nodes"].each { |node| @nodes[place[node["id"]]] = node }
    change["new_nodes"].each do |node|
      expect[!@place.key?(node["id"]), "node #{node["id"]} exists"]
      @place[node["id"]] = @nodes.push(node).size - 1
      [@content, @pressure, @leaked, @filled].each { |values| values << 0.0 }
      @swept << (@revision.zero? ? node["exposure_time"] : nil)
    end
    @nodes.each_with_index { |node, i| @swept[i] ||= 0.5 * (node["exposure_time"] + @time) if node["role"] != TIP }
    @segments = @segments.reject { |segment| change["removed_segments"].include?(segment["id"]) } + change["new_segments"]
    @wells += change["new_perforations"].map { |perforation| place[perforation["node"]] }
    @ends = @segments.map { |segment| [place[segment["node_a"]], place[segment["node_b"]]] }
    @length = @nodes.map { |node| node["lumped_length"] }
    expect[(@length + @segments.map { |segment| segment["length"] }).all?(&:positive?), "a length is not positive"]
    before.each_with_index { |length, i| move_fluid(i, length, before.size) if length != @length[i] }
    near = Array.new(@nodes.size + 1) { [] }
    (@ends + @wells.map { |node| [node, @nodes.size] }).each { |a, b| [near[a] << b, near[b] << a] }
    from_well = [@nodes.size]
    from_well.each { |node| from_well.concat(near[node].uniq - from_well) }
    @rank = (from_well | [*0...@nodes.size]).reverse.each_with_index.to_h
    text = [@revision].pack("Q<")
    @nodes.each { |node| text << node.values_at("id", "x", "y", "lumped_length", "fracture", "role").pack("Q<E3Q<2") }
    @segments.each { |segment| text << segment.values_at("id", "node_a", "node_b", "length").pack("Q<3E") }
    Digest::SHA256.hexdigest(text)
  end

  def advance(message)
    from, to = message.value("begin", Numeric), message.value("end", Numeric)
    follows = to > from && (from == @time || !@in_place) && message.value("carry", String) == "content"
    refuse(22, "the interval from #{from} to #{to} s does not follow #{@time} s, or carries pressure") unless follows
    @aperture, @compliance, @closed = %w[aperture compliance closed].map { |name| message.numbers(name, @nodes.size, 0) }
    @opening, @reference = %w[aperture_rate reference_pressure].map { |name| message.numbers(name, @nodes.size, ANY) }
    arms = message.arrays.keys.grep(/arm/).any? ? %w[a b].map { |arm| "arm_aperture_#{arm}" } : []
    arms = arms.map { |name| message.numbers(name, @segments.size, 0) }.transpose
    @content, @filled = @aperture.dup, @aperture.map { |e| e.positive? ? 1.0 : 0.0 } unless @in_place || @dry # 3.8
    @in_place ||= stored
    @begin, @time, @newton = from, @dry ? to : from, { converged: true, iterations: 0, halvings: 0, residual: 0.0 }
    @edges = @ends.each_with_index.map do |ends, k| # (3d)
      mean = (arms[k] || @aperture.values_at(*ends)).sum { |aperture| [aperture, @floor].max } / 2
      [*ends, mean**3 / (12 * (@mu || 1) * @segments[k]["length"])]
    end + @wells.map { |node| [node, @nodes.size, @well_index] }
    changes = @stages.flat_map { |stage| [stage["begin"], stage["begin"] + stage["ramp"]] } << to
    step(changes.select { |time| time > @time && time <= to }.min) while @time < to
    ledger = { injected: @injected, in_place: @in_place, in_fractures: stored, leaked: @lost, reset: 0.0,
               residual: @injected + @in_place - stored - @lost }.transform_values { |volume| volume * @thickness }
    predicted = @pressure.each_index.map { |i| @dry ? @aperture[i] : aperture(i, @pressure[i])[0] }
    [{ ledger:, newton: @newton, well_pressure: @well_pressure, rate: @rate * @thickness },
     { "pressure" => @pressure, "aperture_predicted" => predicted, "filled" => @filled }]
  end

  def fields = { "pressure" => @pressure, "filled" => @filled, "content" => @content.map { |content| [content, 0.0].max } }
  def stored = @length.zip(@content).sum { |length, content| length * content }

  # What stands on the length that a node loses goes to new neighbours; else it stays there, and is spread.
  def move_fluid(node, before, first_new)
    beside = (@ends.select { |pair| pair.include?(node) }.flatten - [node]).select { |i| i >= first_new }
    share = (before - @length[node]) / beside.sum { |i| @length[i] } if beside.any? && @length[node] < before
    [@content, @leaked].each do |values|
      share ? beside.each { |i| values[i] += share * values[node] } : values[node] *= before / @length[node]
    end
  end

  def target(time) # of the well, between changes of the schedule
    return 0.0 if @stage.nil? || @wells.empty?
    goal, ramp, elapsed = @stage["rate"] / @thickness, @stage["ramp"], time - @stage["begin"]
    elapsed < ramp ? @rate_before + (goal - @rate_before) * elapsed / ramp : goal
  end

  def aperture(node, pressure) # (3b), and its slope
    slope = @closed[node].positive? && pressure < @reference[node] ? 0.0 : @compliance[node]
    open = [@aperture[node] + @opening[node] * (@to - @begin), 0.0].max + slope * (pressure - @reference[node])
    open.negative? ? [0.0, 0.0] : [open, slope]
  end

  # (3c) of u, the pressure in MPa where filled, below 0 the missing share of content: p, dp/du, m, dm/du.
  def cell(node, unknown)
    pressure = [unknown, 0.0].max * MEGAPASCAL
    open, slope = aperture(node, pressure)
    room, density = [open, @floor].max, 1 + pressure / @stiffness
    return [0.0, 0.0, open + unknown * room, room] if unknown.negative?
    [pressure, MEGAPASCAL, open * density, MEGAPASCAL * (slope * density + (open + NUDGE * @floor) / @stiffness)]
  end

  def solve(rows, right) # rows are {column => factor}; the farthest from the well first, so that a tree stays sparse
    @rank.each_key do |k|
      others = rows[k].keys.select { |j| @rank[j] > @rank[k] }
      others.each do |i|
        factor = rows[i][k] / rows[k][k]
        others.each { |j| rows[i][j] -= factor * rows[k][j] }
        right[i] -= factor * right[k]
      end
      rows[k].keep_if { |j, _| j == k || @rank[j] > @rank[k] }
    end
    @rank.keys.reverse_each { |k| right[k] = (right[k] - rows[k].sum { |j, f| j == k ? 0 : f * right[j] }) / rows[k][k] }
  end

  def step(to) # Newton on one unknown for each node and the well
    stage = @stages.reverse.find { |each| each["begin"] <= @time }
    @stage, @rate_before = stage, @rate if stage != @stage
    @to, duration, count, rate = to, to - @time, @nodes.size, target(0.5 * (@time + to))
    exposed = @swept.zip(@nodes).map { |mean, node| [mean ? to - mean : 4.0 / 9 * (to - node["exposure_time"]), 0.0].max } # 3.4
    asked = exposed.zip(@leaked).map { |t, v| t.zero? ? 0.0 : [2 * @spurt + 4 * @carter * Math.sqrt(t) - v, 0.0].max }
    unknown = @filled.zip(@pressure).map { |part, p| part < 1 ? -NUDGE : p / MEGAPASCAL } << @well_pressure / MEGAPASCAL
    (0..@limit).each do
      @channel.progress
      cells = Array.new(count) { |i| cell(i, unknown[i]) } << [unknown.last * MEGAPASCAL, MEGAPASCAL]
      right = Array.new(count) { |i| @length[i] * (cells[i][2] + asked[i] - @content[i]) } << -duration * rate
      moved = right.sum(&:abs)
      noise = (0...count).sum { |i| @length[i] * (cells[i][2].abs + asked[i] + @compliance[i] * @reference[i].abs) }
      rows = (0..count).map { |i| Hash.new(0.0).update(i => i < count ? @length[i] * cells[i][3] : @wells.empty? ? 1.0 : 0.0) }
      @edges.each do |a, b, conductance| # (3a)
        [[a, b], [b, a]].each do |here, there|
          right[here] += duration * conductance * (cells[here][0] - cells[there][0])
          rows[here][here] += duration * conductance * cells[here][1]
          rows[here][there] -= duration * conductance * cells[there][1]
          noise += duration * conductance * cells[here][0].abs
        end
      end
      imbalance = right.sum(&:abs)
      @newton.update(iterations: @newton[:iterations] + 1, residual: imbalance / [moved, Float::MIN].max)
      return accept(duration, rate, unknown, cells, asked) if imbalance <= @tolerance * moved + ROUNDING * noise
      solve(rows, right)
      right.each_with_index do |change, i|
        aim = unknown[i] - change
        crossed = i < count && aim.negative? != unknown[i].negative?
        unknown[i] = crossed ? (aim.negative? ? -NUDGE : NUDGE) : aim
      end
    end
    refuse(24, "the flow from #{@time} to #{to} s did not converge: imbalance #{@newton[:residual]}")
  end

  # Contents follow from the fluxes, and the perforations bring the given rate to the last digit.
  def accept(duration, rate, unknown, cells, asked)
    flow = @edges.map { |a, b, conductance| duration * conductance * (cells[a][0] - cells[b][0]) }
    missing = (duration * rate + flow.last(@wells.size).sum) / [@wells.size, 1].max
    @edges.each_with_index do |(a, b, _), k|
      flow[k] -= missing if b == @nodes.size
      @content[a] -= flow[k] / @length[a]
      b == @nodes.size ? @injected -= flow[k] : @content[b] += flow[k] / @length[b]
    end
    @content.each_index do |i|
      taken, room = @content[i].clamp(0.0, asked[i]), aperture(i, 0.0)[0]
      @content[i], @leaked[i], @lost = @content[i] - taken, @leaked[i] + taken, @lost + @length[i] * taken
      part = room.zero? ? 0.0 : (@content[i] / room).clamp(0.0, 1.0.prev_float)
      @pressure[i], @filled[i] = cells[i][0], unknown[i] >= 0 ? 1.0 : part
    end
    @time, @well_pressure, @rate = @to, unknown.last * MEGAPASCAL, target(@to)
  end
end

ALLOWED = { greeting: %i[welcome reject], empty: [:insert], ready: %i[insert advance report finish], leaving: [:bye] }.freeze

def serve(channel)
  channel.say(:hello, 0, { role: "network", solver: "flow_solver.rb", version: "1", pid: Process.pid,
                           capabilities: %w[insert report], physics: %w[viscous_flow leak_off] })
  state, solver, revision, work = :greeting, nil, 0, 0.0
  loop do
    message = channel.hear(0.5) or next
    type, begun = message.type, now
    refuse(22, "#{type} came, state #{state}") unless ALLOWED[state].include?(type)
    refuse(22, "#{type} is for another revision") if %i[advance report].include?(type) && message.revision != revision
    case type
    when :reject, :bye then return type == :bye ? 0 : message.value("exit_code", Integer)
    when :welcome
      solver = FlowSolver.new(message.value("case", Hash), channel)
      channel.deadline = message.value("coupler_deadline", Numeric)
    when :insert
      hash, revision = solver.insert(message.value("insertion", Hash)), message.revision
      channel.say(:acknowledge, revision, { hash: })
    when :advance then channel.say(:pressure, revision, *solver.advance(message))
    when :report then channel.say(:fields, revision, { geometry: revision }, solver.fields)
    when :finish then channel.say(:bye, revision, { figures: { work_seconds: work } })
    end
    state = { welcome: :empty, finish: :leaving }.fetch(type, :ready)
    work += now - begun
  end
rescue StandardError, NoMemoryError => failure
  code = { NoMemoryError => 26 }.fetch(failure.class) { failure.is_a?(Refusal) ? failure.code : 70 }
  return warn("network: #{failure.message}") || code if failure.is_a?(Lost)
  channel.say(:fail, 0, { role: "network", phase: "work", reason: failure.message, exit_code: code })
  20.times { channel.hear(0.1) } rescue nil # ended by the FAIL of the coupler
  code
end
exit(serve(Channel.new(ARGV[ARGV.index("--connect") + 1])))
